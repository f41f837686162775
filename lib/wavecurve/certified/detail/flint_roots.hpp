#pragma once

// Complex balls and the certified roots of polynomials; see certified/flint.hpp.

// clang-format off
#include <flint/fmpz_poly.h>
#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/acb.h>
#include <flint/arb_fmpz_poly.h>
#else
#include <acb.h>
#include <arb_fmpz_poly.h>
#endif
// clang-format on
