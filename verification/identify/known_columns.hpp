#pragma once

#include <string>
#include <vector>

#include "wavecurve/filters/filter.hpp"

#include "verification/quantities/quantity.hpp"

namespace wavecurve::verification {

/// A column that a list of numbers may be: a quantity of a filter, in double precision.
struct KnownColumn {
  std::string filter;
  Quantity quantity;
  Filter<double> values;
};

/// Every filter of the finite families and the splines of filter_names(), with its taps, the dual
/// ones of a biorthogonal pair, alpha, the integrals of products of phi, and of psi, with up to two
/// derivatives each as far as they exist, mu/mu0 and nu/nu0, Beylkin's r, the values of phi at the
/// integers, and the lifting steps of the symmetric pairs. The library's double-precision tables
/// and solvers make them, so that all of it takes a fraction of a second; what they match is proved
/// by check_table. Computed once.
const std::vector<KnownColumn>& known_columns();

}  // namespace wavecurve::verification
