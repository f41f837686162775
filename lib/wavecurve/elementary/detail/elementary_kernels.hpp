#pragma once

#include <string_view>

#include <Eigen/Core>

namespace wavecurve::elementary {

/// Throws std::invalid_argument if a result has another size than x.
void check_sizes(std::string_view function, Eigen::Index x, Eigen::Index result);

/// The functions of arrays, with the bits of the functions of one number. Results may be stored in
/// the place of x.
void sine_cosine_of_array(const double* x, Eigen::Index size, double* sine, double* cosine);
void exponential_of_array(const double* x, Eigen::Index size, double* result);

}  // namespace wavecurve::elementary
