#pragma once

// Where FLINT keeps the two headers that Rational and Ball need: FLINT 3 contains Arb, FLINT 2 has
// it beside itself. detail/flint_matrices.hpp and detail/flint_roots.hpp do the same for what single
// files use, so that a user of Ball does not read it all.

// clang-format off
#include <flint/fmpq.h>
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif
// clang-format on
