// Loaded before a program (LD_PRELOAD), this library restricts Highway to the instructions that
// every processor of the kind has. With the C library's own restriction,
//   GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,...
// the program computes as on an old processor; tools/same_results.sh holds it against this one.
#include <cstdio>
#include <cstdlib>

#include <hwy/targets.h>

namespace {

[[gnu::constructor]] void restrict_highway() {
  hwy::DisableTargets(~static_cast<std::int64_t>(HWY_BASELINE_TARGETS));
  // Who asks whether the restriction came into force looks for this file.
  if (const char* path = std::getenv("RESTRICTED_HIGHWAY")) {
    if (std::FILE* file = std::fopen(path, "w")) {
      std::fprintf(file, "%lld\n", static_cast<long long>(hwy::SupportedTargets()));
      std::fclose(file);
    }
  }
}

}  // namespace
