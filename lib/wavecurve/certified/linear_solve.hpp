#pragma once

#include <optional>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve::certified {

/// The solution of A x = b, with proof that A is regular: every matrix in the enclosure A is. Empty
/// if that could not be proved at the working precision (Ball), or is not so (Rational). Throws
/// std::invalid_argument if b is not as long as A is high.
std::optional<std::vector<Ball>> solve(const SquareMatrix<Ball>& a, const std::vector<Ball>& b);
std::optional<std::vector<Rational>> solve(const SquareMatrix<Rational>& a,
                                           const std::vector<Rational>& b);

}  // namespace wavecurve::certified
