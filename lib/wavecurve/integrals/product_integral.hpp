#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wavecurve/filters/basis_function.hpp"

namespace wavecurve {

/// A factor f(2^level x - l) of a product, f a derivative of phi, psi, phi~ or psi~; of a
/// derivative it is f^(d) at the place 2^level x - l, without the factor 2^(d level) of the chain
/// rule.
struct IntegralFactor {
  BasisFunction function;
  bool shifted = true;  ///< false for l = 0
  int level = 0;

  bool operator==(const IntegralFactor&) const = default;
};

/// From first / 2^level to last / 2^level.
struct DyadicInterval {
  int first = 0, last = 1;
  int level = 0;

  bool operator==(const DyadicInterval&) const = default;
};

/// The integrals
///   I(l, m, ..) = int x^power f_1(2^j1 x - l_1) .. f_k(2^jk x - l_k) dx
/// over the line or an interval, for all l_i of the factors that are shifted, in their order. On
/// the line the first factor is not shifted, since all of them may be shifted together.
struct ProductIntegral {
  std::vector<IntegralFactor> factors;
  int power = 0;
  std::optional<DyadicInterval> interval = {};
  /// The period of the factors, made periodic (integrals/periodic.hpp), over which then is
  /// integrated.
  std::optional<int> period = {};
};

/// Bounds of what is accepted; the last two bound memory to about 1 GiB, and time with it.
inline constexpr int most_factors = 4;             ///< on an interval one less
inline constexpr int highest_power = 20;           ///< of x
inline constexpr int highest_integral_level = 10;  ///< of a factor and of the interval's ends
inline constexpr long most_unknowns = 4096;        ///< of the two-scale system
inline constexpr long most_integrals = 4'000'000;  ///< of the result, and on the way to it

/// "int x phi'(x) phi(2x - l) over [0, 1/2]" for messages.
std::string name_of(const ProductIntegral& integral);

/// Throws std::invalid_argument for what is beyond the bounds above, for a derivative outside
/// 0 .. highest_derivative, for an interval that is empty or reversed, and on the line for a first
/// factor that is shifted; for a period that is not positive, or stands beside a power of x, an
/// interval or finer levels.
void check_integral(const ProductIntegral& integral);

}  // namespace wavecurve
