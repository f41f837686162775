#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "wavecurve/integrals/product_integral.hpp"

namespace wavecurve::verification {

/// The integral of a text in the grammar of int(...) of quantity.hpp, with up to four factors,
/// powers of x, and functions of finer levels:
///   integral   { x | x^p | F | F(s) }, blanks, commas or * between them
///   F          phi or psi, ~ for the dual, primes or ^(p) for derivatives
///   s          l for F(x - l), or [2^j]x [- l]: psi(2x - l)
/// "phi' phi(l) phi(m)" is int phi'(x) phi(x - l) phi(x - m) dx. Letters are the indices in order
/// of appearance. Without letters the first factor stands at x, the others are shifted by l, m, n.
///
/// On the line a factor without a letter must be there, and is put first; on an interval all may
/// have one. Throws std::invalid_argument with the column where the text is no longer understood,
/// or as check_integral does.
ProductIntegral parse_integral(std::string_view text,
                               const std::optional<DyadicInterval>& interval = {});

/// The interval "a,b" with integers or dyadic points for ends: "0,1", "-1/2,0.75". Throws
/// std::invalid_argument for another text, a point beyond 10^5 in magnitude or finer than
/// 2^-highest_integral_level, and ends in the wrong order.
DyadicInterval parse_interval(std::string_view text);

/// Whether the text is "0,x", for the integrals from 0 to every x.
bool is_up_to_x(std::string_view text);

/// "0,1", "-1/2,3/4".
std::string to_string(const DyadicInterval& interval);

/// The shortest text for it: "phi', phi, phi", "x^2, phi(l), psi(2x - m)".
std::string to_string(const ProductIntegral& integral);

}  // namespace wavecurve::verification
