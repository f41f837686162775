#pragma once

// Matrices of FLINT and Arb; see certified/flint.hpp.

// clang-format off
#include <flint/fmpq_mat.h>
#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif
// clang-format on
