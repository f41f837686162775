#include "wavecurve/certified/detail/relations.hpp"

#include <algorithm>

namespace wavecurve::certified {

namespace {

template <class Scalar>
Scalar sum_of_taps(const Filter<Scalar>& low) {
  Scalar sum(0);
  for (const Scalar& tap : low.taps) sum += tap;
  return sum;
}

/// sum_k (-1)^k k^j low_k for j = 0, 1, 2, ..., one with each call. k is counted from the middle of
/// the taps: where the lower moments vanish, the origin does not matter, and so the weights are
/// small, and with them what the errors of the taps add up to.
template <class Scalar>
class AlternatingMoments {
 public:
  explicit AlternatingMoments(const Filter<Scalar>& low) : terms_(low.taps) {
    for (std::size_t k = 1; k < terms_.size(); k += 2) terms_[k] = -terms_[k];
  }

  Scalar next() {
    Scalar sum(0);
    const long last = static_cast<long>(terms_.size()) - 1;
    for (long k = 0; k <= last; ++k) {
      Scalar& term = terms_[static_cast<std::size_t>(k)];
      sum += term;
      term *= Scalar(2 * k - last) / Scalar(2);
    }
    return sum;
  }

 private:
  std::vector<Scalar> terms_;
};

template <class Scalar>
void append_side(std::vector<Relation<Scalar>>& relations, const std::string& side,
                 const Filter<Scalar>& low, int zeros, const Scalar& sum) {
  relations.push_back({"sum_k " + side + "_k = sqrt 2", sum_of_taps(low) - sum});
  AlternatingMoments moments(low);
  for (int j = 0; j < zeros; ++j) {
    relations.push_back(
        {"sum_k (-1)^k k^" + std::to_string(j) + " " + side + "_k = 0", moments.next()});
  }
}

template <class Scalar>
void append_biorthonormality(std::vector<Relation<Scalar>>& relations,
                             const FilterBank<Scalar>& bank, const Scalar& norm) {
  const Filter<Scalar>&analysis = bank.analysis_low, &synthesis = bank.synthesis_low;
  const int first = synthesis.first_index - analysis.last_index();
  const int last = synthesis.last_index() - analysis.first_index;
  for (int lag = first - first % 2; lag <= last; lag += 2) {
    if (bank.is_orthonormal() && lag < 0) continue;
    Scalar sum(0);
    for (int k = analysis.first_index; k <= analysis.last_index(); ++k) {
      sum += analysis[k] * synthesis[k + lag];
    }
    relations.push_back({"sum_k analysis_low_k synthesis_low_{k+" + std::to_string(lag) +
                             "} = " + (lag == 0 ? "1" : "0"),
                         lag == 0 ? sum - norm : sum});
  }
}

}  // namespace

template <class Scalar>
std::vector<Relation<Scalar>> filter_relations(const FilterBank<Scalar>& bank, const Scalar& sum) {
  std::vector<Relation<Scalar>> relations;
  append_side(relations, "synthesis_low", bank.synthesis_low, bank.vanishing_moments, sum);
  if (!bank.is_orthonormal()) {
    append_side(relations, "analysis_low", bank.analysis_low, bank.dual_vanishing_moments, sum);
  }
  append_biorthonormality(relations, bank, Scalar(sum * sum / Scalar(2)));
  return relations;
}

std::optional<Relation<Ball>> violated_relation(const FilterBank<Ball>& bank) {
  for (Relation<Ball>& relation : filter_relations(bank, sqrt(Ball(2)))) {
    if (!relation.residual.contains_zero()) return relation;
  }
  return std::nullopt;
}

bool satisfies_relations(const FilterBank<Rational>& bank, const Rational& sum) {
  const auto relations = filter_relations(bank, sum);
  return std::all_of(relations.begin(), relations.end(),
                     [](const auto& relation) { return relation.residual.contains_zero(); });
}

template <class Scalar>
int zeros_at_pi(const Filter<Scalar>& low) {
  AlternatingMoments moments(low);
  int count = 0;
  while (count < low.size() - 1 && moments.next().contains_zero()) ++count;
  return count;
}

template std::vector<Relation<double>> filter_relations(const FilterBank<double>&, const double&);
template std::vector<Relation<Ball>> filter_relations(const FilterBank<Ball>&, const Ball&);
template std::vector<Relation<Rational>> filter_relations(const FilterBank<Rational>&,
                                                          const Rational&);
template int zeros_at_pi(const Filter<Ball>&);
template int zeros_at_pi(const Filter<Rational>&);

}  // namespace wavecurve::certified
