#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/certified/basis_function.hpp"
#include "wavecurve/integrals/product_integral.hpp"

namespace wavecurve::verification {

struct QuantityFamily;

/// A function in a quantity, shifted by an index or not: phi'(x - l).
struct Factor {
  certified::BasisFunction function;
  int shift = 0;  ///< 0 for none, 1 for the first letter l, 2 for the second, m, 3 for n

  bool operator==(const Factor&) const = default;
};

/// What a column of a table lists: a family (verification/quantities/quantity_families.hpp), the
/// functions it is about, and a factor.
///
///   quantity   [-] family [on [a,b]] [suffixes]
///   family     h, g, dual(h), dual(g)     taps of phi, psi, phi~, psi~; sum sqrt 2; index n
///              alpha                      autocorrelation of h, (3.9)
///              mu, nu                     int(phi', phi'), int(psi', psi'): (3.10)
///              r                          int(phi(l), phi'): Beylkin 1992
///              int(F, F), .. four F       integrals of products over the line; with
///                                         "on [a,b]", a and b dyadic, of up to three over an
///                                         interval; with "on [0,x]" from 0 to x, the first index
///              phi, psi'', dual(phi)      values at integers and dyadic points x
///              lifting                    lifting steps and, last, the factor; index k
///              moment(phi)                int x^p phi(x) dx; index p. So are sobolev(phi) and
///                                         every other family of one function written
///   F          phi or psi, ~ for the dual, primes or ^(p) for derivatives, then the shift:
///              phi'(l) is phi'(x - l). Letters are the indices in order of appearance; without
///              letters the first factor stands at x, the others are shifted by l, m and n. On
///              the line one factor stands at x, on an interval any number of them.
///   suffixes   *sqrt2, /sqrt2, *2, /2, and /first: divided by the entry of the smallest index >= 0
///              that does not vanish (mu/mu0 and nu/nu0 are mu/first and nu/first).
struct Quantity {
  const QuantityFamily* family = nullptr;
  std::vector<Factor> factors;
  int half_powers = 0;  ///< times sqrt(2)^half_powers
  bool negated = false;
  bool divided_by_first = false;
  /// The interval of an integral, if it is not over the line; up_to_x is [0, x].
  std::optional<DyadicInterval> interval = {};
  bool up_to_x = false;

  bool operator==(const Quantity&) const = default;

  // The quantities of the publication's tables.
  static const Quantity taps, taps_sum_2, taps_sum_1, autocorrelation, mu, nu, mu_normalized,
      nu_normalized;

  /// How many numbers its index has.
  int index_count() const;

  /// The same without factor, sign and division.
  Quantity bare() const;
};

/// The quantity of a name in the grammar above; blanks are free. Throws std::invalid_argument with
/// the column where the name is no longer understood.
Quantity parse_quantity(std::string_view text);

/// The shortest name in the grammar, such as "h*sqrt2".
std::string to_string(const Quantity& quantity);

/// sqrt(2)^half_powers as a suffix: "*sqrt2", "/2", or nothing.
std::string factor_text(int half_powers);

/// Taps of phi's filter, with any sum.
bool is_taps(const Quantity& quantity);

/// The grammar in a line for each family, for help and documentation.
std::string quantities_help();

}  // namespace wavecurve::verification
