#pragma once

#include <functional>
#include <optional>
#include <string>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve::certified {

/// The autocorrelations alpha_n, n = 0 .. L-1 (see filters/autocorrelation.hpp), of both low-pass
/// filters, where they are rational numbers.
struct ExactAutocorrelations {
  Filter<Rational> synthesis, analysis;
};

/// A filter bank that can be had at any precision.
struct FilterDefinition {
  /// The canonical name, such as "db4".
  std::string name;
  /// The bank with enclosures of at least this many bits of relative accuracy a tap, if the
  /// definition allows it (a user's own decimals do not).
  std::function<FilterBank<Ball>(long bits)> bank;
  /// Exact autocorrelations; empty for families whose autocorrelation is irrational.
  std::optional<ExactAutocorrelations> exact;
  /// The bits behind the point to which the taps of the synthesis side, and those of the analysis
  /// side, are known: a user's own decimals may stand for more than one number. Empty where any
  /// accuracy can be had.
  std::optional<long> known_bits = {}, dual_known_bits = {};
  /// The two-scale coefficients sqrt 2 h_k and sqrt 2 g_k of all four filters, where they are
  /// rational numbers: of splines, and of a user's own taps that are exact.
  std::optional<FilterBank<Rational>> two_scale = {};
};

/// The same bank with the analysis and the synthesis side exchanged, so that every question about
/// phi can be asked about the dual scaling function.
FilterDefinition dual(const FilterDefinition& definition);

/// The same under a name of its own; without one it is called "dual of " and the name.
FilterDefinition dual(const FilterDefinition& definition, const std::string& name);

}  // namespace wavecurve::certified
