#include "verification/identify/identify.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/elementary/root.hpp"

namespace wavecurve::verification {

namespace {

constexpr double relative_tolerance = 2e-5;  // tables that are right to five digits are found
constexpr int most_half_powers = 4;
constexpr std::size_t most_candidates = 60;
/// Some 10^5 entries, ten factors and 10^2 overlays are tried: 10^8 chances. A number that agrees to d
/// decimal digits does so by chance once in 10^d.
constexpr double least_evidence = 10;

/// The list as the search sees it.
struct Query {
  std::vector<double> values, tolerances;
  double largest = 0;
};

Query query_of(const NumberList& list) {
  Query query;
  for (const PrintedNumber& number : list.numbers) {
    const double value = number.to_double();
    const double unit = certified::Ball(number.unit()).to_double();
    query.values.push_back(value);
    query.tolerances.push_back(std::max(2 * unit, relative_tolerance * std::abs(value)));
    query.largest = std::max(query.largest, std::abs(value));
  }
  return query;
}

/// An entry of the index.
struct Magnitude {
  double size;
  std::size_t column;
};

/// All magnitudes of all columns, sorted.
class MagnitudeIndex {
 public:
  enum class Divisor { one, largest_entry };

  explicit MagnitudeIndex(Divisor divisor) {
    const auto& columns = known_columns();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      double largest = 0;
      for (const double value : columns[c].values.taps)
        largest = std::max(largest, std::abs(value));
      const double by = divisor == Divisor::one ? 1 : largest;
      for (const double value : columns[c].values.taps) {
        if (value != 0) magnitudes_.push_back({std::abs(value) / by, c});
      }
    }
    std::sort(magnitudes_.begin(), magnitudes_.end(),
              [](const Magnitude& a, const Magnitude& b) { return a.size < b.size; });
  }

  /// Calls vote(column) for every magnitude within the tolerance.
  template <class Vote>
  void find(double size, double tolerance, Vote vote) const {
    const auto begin =
        std::lower_bound(magnitudes_.begin(), magnitudes_.end(), size - tolerance,
                         [](const Magnitude& m, double bound) { return m.size < bound; });
    for (auto m = begin; m != magnitudes_.end() && m->size <= size + tolerance; ++m)
      vote(m->column);
  }

 private:
  std::vector<Magnitude> magnitudes_;
};

/// The numbers that say most: the largest, for the small ones of a column are in many.
std::vector<std::size_t> telling_numbers(const Query& query) {
  constexpr std::size_t most = 12;
  std::vector<std::size_t> order(query.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(query.values[a]) > std::abs(query.values[b]);
  });
  order.resize(std::min(order.size(), most));
  return order;
}

/// A column with a factor, by which its values are to be multiplied.
struct Candidate {
  std::size_t column = 0;
  double scale = 1;
  std::optional<int> half_powers;
  int votes = 0;
};

std::vector<Candidate> candidates_of(const Query& query) {
  static const MagnitudeIndex plain(MagnitudeIndex::Divisor::one),
      divided(MagnitudeIndex::Divisor::largest_entry);
  std::map<std::pair<std::size_t, int>, int> votes;
  std::map<std::size_t, int> votes_of_divided;
  for (const std::size_t i : telling_numbers(query)) {
    const double size = std::abs(query.values[i]), tolerance = query.tolerances[i];
    // A number without a digit that is sure is among the small ones of nearly every column.
    if (size < 10 * tolerance) continue;
    for (int k = -most_half_powers; k <= most_half_powers; ++k) {
      const double scale = power_of_root_two(k);
      plain.find(size / scale, tolerance / scale, [&](std::size_t c) { ++votes[{c, k}]; });
    }
    divided.find(size / query.largest, 2 * tolerance / query.largest,
                 [&](std::size_t c) { ++votes_of_divided[c]; });
  }
  std::vector<Candidate> candidates;
  for (const auto& [key, count] : votes) {
    candidates.push_back({key.first, power_of_root_two(key.second), key.second, count});
  }
  for (const auto& [column, count] : votes_of_divided) {
    double largest = 0;
    for (const double v : known_columns()[column].values.taps)
      largest = std::max(largest, std::abs(v));
    candidates.push_back({column, query.largest / largest, std::nullopt, count});
  }
  // Among equals a power of sqrt 2 comes first, and the smallest of those.
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    const auto rank = [](const Candidate& c) {
      return c.half_powers ? std::abs(*c.half_powers) : most_half_powers + 1;
    };
    return a.votes != b.votes ? a.votes > b.votes : rank(a) < rank(b);
  });
  candidates.resize(std::min(candidates.size(), most_candidates));
  return candidates;
}

int complexity(const Match& match) {
  const Convention& c = match.convention;
  return int(c.reversed) + int(c.negated) + 2 * int(c.alternating) + int(c.shift != 0) +
         (match.scale_is_power ? int(c.half_powers != 0) : 4) + (match.in_order ? 0 : 6);
}

bool is_better(const Match& a, const Match& b) {
  if (a.matched != b.matched) return a.matched > b.matched;
  if (complexity(a) != complexity(b)) return complexity(a) < complexity(b);
  if (a.convention.shift != b.convention.shift) {
    return std::abs(a.convention.shift) < std::abs(b.convention.shift);
  }
  return std::lround(a.digits) > std::lround(b.digits);
}

/// Lays the column over the list: entry i has the index first + i, its value stands at `source`.
class Overlay {
 public:
  Overlay(const Query& query, const Candidate& candidate, std::optional<int> first_index)
      : query_(query),
        candidate_(candidate),
        values_(known_columns()[candidate.column].values),
        first_(first_index.value_or(values_.first_index)) {}

  Match best() const {
    Match best = unordered();
    const int n = static_cast<int>(query_.values.size()), size = values_.size();
    for (const bool reversed : {false, true}) {
      for (int begin = 1 - n; begin < size; ++begin) consider(reversed, begin, best);
    }
    return best;
  }

 private:
  /// `begin` is where the list's first entry falls, counted from the support's first index, or
  /// backwards from its last.
  void consider(bool reversed, int begin, Match& best) const {
    Convention convention{.reversed = reversed, .half_powers = candidate_.half_powers.value_or(0)};
    const int source = values_.first_index + begin;
    // n + shift = source at n = first_; reversed: first + last - n + shift = last - begin.
    convention.shift = reversed ? first_ - begin - values_.first_index : source - first_;
    for (const bool alternating : {false, true}) {
      for (const bool negated : {false, true}) {
        convention.alternating = alternating;
        convention.negated = negated;
        const Match match = match_of(convention);
        if (is_better(match, best)) best = match;
      }
    }
  }

  double expected(const Convention& convention, int i) const {
    const int n = first_ + i;
    const int source = convention.reversed
                           ? values_.first_index + values_.last_index() - n + convention.shift
                           : n + convention.shift;
    const bool minus = (convention.alternating && n % 2 != 0) != convention.negated;
    return (minus ? -candidate_.scale : candidate_.scale) * values_[source];
  }

  Match base() const {
    Match match;
    match.column = &known_columns()[candidate_.column];
    match.scale = candidate_.scale;
    match.scale_is_power = candidate_.half_powers.has_value();
    match.of = static_cast<int>(query_.values.size());
    return match;
  }

  void add(Match& match, double& worst, std::size_t i, double expected) const {
    const double error = std::abs(query_.values[i] - expected);
    if (error > query_.tolerances[i]) return;
    ++match.matched;
    const double size = std::abs(query_.values[i]);
    match.evidence += size > query_.tolerances[i] ? logarithm_10(size / query_.tolerances[i]) : 0;
    worst = std::max(worst, error);
  }

  void finish(Match& match, double worst) const {
    constexpr double most_digits = 17;
    match.digits = worst == 0 ? most_digits
                              : std::clamp(-logarithm_10(worst / query_.largest), 0.0, most_digits);
  }

  Match match_of(const Convention& convention) const {
    Match match = base();
    match.convention = convention;
    double worst = 0;
    for (std::size_t i = 0; i < query_.values.size(); ++i) {
      add(match, worst, i, expected(convention, static_cast<int>(i)));
    }
    finish(match, worst);
    return match;
  }

  /// Each number held against the nearest magnitude of the column.
  Match unordered() const {
    Match match = base();
    match.in_order = false;
    match.convention.half_powers = candidate_.half_powers.value_or(0);
    double worst = 0;
    for (std::size_t i = 0; i < query_.values.size(); ++i) {
      double nearest = 0;
      for (const double value : values_.taps) {
        const double scaled = std::copysign(candidate_.scale * std::abs(value), query_.values[i]);
        if (std::abs(query_.values[i] - scaled) < std::abs(query_.values[i] - nearest)) {
          nearest = scaled;
        }
      }
      if (nearest != 0) add(match, worst, i, nearest);
    }
    finish(match, worst);
    return match;
  }

  const Query& query_;
  const Candidate& candidate_;
  const Filter<double>& values_;
  int first_;
};

bool is_convincing(const Match& match) {
  return match.matched >= 2 && 3 * match.matched >= 2 * match.of &&
         match.evidence >= least_evidence;
}

}  // namespace

std::vector<Match> identify(const NumberList& list) {
  const Query query = query_of(list);
  if (query.largest == 0) return {};
  std::vector<Match> matches;
  for (const Candidate& candidate : candidates_of(query)) {
    const Match match = Overlay(query, candidate, list.first_index).best();
    if (!is_convincing(match)) continue;
    const auto same = std::find_if(matches.begin(), matches.end(), [&](const Match& m) {
      return m.column->filter == match.column->filter;
    });
    if (same == matches.end()) {
      matches.push_back(match);
    } else if (is_better(match, *same)) {
      *same = match;
    }
  }
  std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    if (is_better(a, b) != is_better(b, a)) return is_better(a, b);
    return a.column < b.column;
  });
  return matches;
}

std::vector<NearMiss> nearest_columns(const NumberList& list, const std::vector<Match>& matches) {
  /// Magnitudes divided by the largest, that first.
  const auto magnitudes = [](const std::vector<double>& values) {
    std::vector<double> sizes;
    for (const double value : values) sizes.push_back(std::abs(value));
    std::sort(sizes.rbegin(), sizes.rend());
    const double largest = sizes.empty() ? 0 : sizes.front();
    for (double& size : sizes) size = largest == 0 ? 0 : size / largest;
    return sizes;
  };
  const std::vector<double> wanted = magnitudes(query_of(list).values);
  std::vector<NearMiss> misses;
  for (const KnownColumn& column : known_columns()) {
    const bool is_matched = std::any_of(matches.begin(), matches.end(), [&](const Match& match) {
      return match.column->filter == column.filter;
    });
    if (is_matched) continue;
    const std::vector<double> sizes = magnitudes(column.values.taps);
    double distance = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      distance = std::max(distance, std::abs(wanted[i] - (i < sizes.size() ? sizes[i] : 0)));
    }
    misses.push_back({&column, distance});
  }
  constexpr std::size_t shown = 3;
  std::stable_sort(misses.begin(), misses.end(),
                   [](const NearMiss& a, const NearMiss& b) { return a.distance < b.distance; });
  misses.resize(std::min(misses.size(), shown));
  return misses;
}

std::string scale_text(const Match& match) {
  if (!match.scale_is_power) return fmt::format("{:.6g}", match.scale);
  const int k = match.convention.half_powers, whole = std::abs(k) / 2;
  std::string text = k % 2 == 0 ? std::to_string(1 << whole)
                                : (whole == 0 ? "" : std::to_string(1 << whole) + "*") + "sqrt2";
  if (k >= 0) return text;
  return text.find('*') == std::string::npos ? "1/" + text : "1/(" + text + ")";
}

}  // namespace wavecurve::verification
