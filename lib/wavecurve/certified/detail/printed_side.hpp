#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/filter.hpp"

namespace wavecurve::certified {

/// A low-pass filter as a user printed it: what each tap says, and how much it may be off.
class PrintedSide {
 public:
  /// Throws std::invalid_argument as define_user_filter does.
  PrintedSide(const std::string& filter_name, const Filter<std::string>& printed, std::string sum,
              const std::optional<std::string>& accuracy);

  /// The same with another bound of the errors; a zero stays exact.
  PrintedSide with_accuracy(const Rational& accuracy) const;

  /// The enclosures, in the orthonormal normalisation.
  Filter<Ball> enclosures() const;
  /// The numbers as they stand, scaled to the sum 2.
  Filter<Rational> scaled_to_two() const;
  /// The factor from the printed normalisation to the orthonormal one.
  Ball normalising_factor() const;
  /// Whether the sum is that of decimals that may be exact: with sqrt 2 none are.
  bool may_be_exact() const { return sum_ != "sqrt2" && !has_stated_accuracy_; }
  bool has_stated_accuracy() const { return has_stated_accuracy_; }
  /// The bits behind the point that all taps are known to; nothing if they are exact.
  std::optional<long> known_bits() const;
  void make_exact() { radii_.assign(radii_.size(), Rational(0)); }

 private:
  Filter<Rational> taps_;
  std::vector<Rational> radii_;
  std::string sum_;
  bool has_stated_accuracy_;
};

}  // namespace wavecurve::certified
