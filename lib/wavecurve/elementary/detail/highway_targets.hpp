#pragma once

// Instruction sets that no kernel is built for; to be included before Highway. SVE and RVV: vectors
// without a size known to the compiler could not be members of an array; such processors run the
// baseline kernels. SSSE3: so do the processors that stop short of SSE4 (scalar code, with Highway
// 1.0).
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3)
