#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/rational.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve::certified {

/// One equation that a filter bank has to satisfy. Scalar is Ball, Rational or double.
template <class Scalar>
struct Relation {
  std::string equation;  ///< "sum_k synthesis_low_k = sqrt 2"
  Scalar residual;       ///< left-hand side minus right-hand side
};

/// All relations of a bank whose low-pass filters are to add up to `sum` (sqrt 2 in the orthonormal
/// normalisation): these two sums; the biorthonormality
/// sum_k analysis_low_k synthesis_low_{k+2n} = (sum^2 / 2) delta_n at every lag where they overlap;
/// the alternating moments sum_k (-1)^k k^j low_k = 0, j < N, that make N zeros at pi on either
/// side. For an orthonormal bank the two sides are one and each relation is listed once.
template <class Scalar>
std::vector<Relation<Scalar>> filter_relations(const FilterBank<Scalar>& bank, const Scalar& sum);

/// The first relation that is proved not to hold.
std::optional<Relation<Ball>> violated_relation(const FilterBank<Ball>& bank);

/// Whether every relation holds exactly, in the normalisation of the given sum.
bool satisfies_relations(const FilterBank<Rational>& bank, const Rational& sum);

/// The number of zeros at pi that a low-pass filter has (Rational) or that its enclosures admit
/// (Ball).
template <class Scalar>
int zeros_at_pi(const Filter<Scalar>& low);

}  // namespace wavecurve::certified
