#pragma once

#include <optional>
#include <string>

namespace wavecurve::tools {

/// What is listed of an operator: r_l for |l| <= largest, or the periodic ones for l = 0 .. period - 1.
struct OperatorRange {
  int largest = 10;
  std::optional<int> period;
};

/// `coefficients NAME --operator O [--up-to L | --period N]`: r_l = int phi(x - l) (T phi)(x) dx, where T is
///   hilbert[:S], fractional:S, riesz:S (S a decimal or a fraction), or derivative:K
/// of the symbols -i sgn(w) |w|^S, (i w)^S, |w|^S and (i w)^K. A fractional derivative of whole order
/// S >= 0 is derivative:S. Throws std::invalid_argument for
/// another text, and as io::load_filter, certified::operator_coefficients and
/// certified::integral_decimals.
std::string operator_output(const std::string& filter, const std::string& text,
                            const OperatorRange& range, int digits, const std::string& format);

/// `coefficients NAME --moments P`: moments of phi and psi (of both sides, where they differ) up to
/// P; the numbers a_p by which the shifts of phi reproduce polynomials; weights of the quadrature
/// rule for phi with P + 1 nodes at whole numbers about its first moment, at most as many as lie in
/// its support (certified/moments.hpp, certified/integrals/quadrature.hpp).
std::string moments_output(const std::string& filter, int highest, int digits,
                           const std::string& format);

}  // namespace wavecurve::tools
