#include "verification/quantities/convention.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/elementary/root.hpp"
#include "wavecurve/io/files/detail/text.hpp"

#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

namespace {

struct IndexRange {
  int first = 0, last = 0;
};

IndexRange support_of(FilterValues& filter, const Quantity& quantity) {
  const auto [first, last] = filter.index_range(quantity);
  return {first, last};
}

Quantity exchanged(Quantity quantity) {
  for (Factor& factor : quantity.factors) factor.function.dual = !factor.function.dual;
  return quantity;
}

int source(const Convention& convention, IndexRange support, int n) {
  return convention.reversed ? support.first + support.last - n + convention.shift
                             : n + convention.shift;
}

int sign(const Convention& convention, int n) {
  const bool odd = convention.alternating && n % 2 != 0;
  return odd != convention.negated ? -1 : 1;
}

/// Reversal and signs by index make sense for sequences over the integers.
bool has_conventions(const Quantity& quantity) {
  const std::string_view family = quantity.family->name;
  return family == "h" || family == "alpha" || (family == "int" && quantity.factors.size() == 2);
}

// --- recognition ---

/// The values of a quantity in double precision, over its support.
class Samples {
 public:
  Samples(FilterValues& filter, const Quantity& quantity) : support_(support_of(filter, quantity)) {
    for (int n = support_.first; n <= support_.last; ++n) {
      values_.push_back(filter.value(quantity, EntryIndex(n)).to_double());
    }
  }
  IndexRange support() const { return support_; }
  std::optional<double> operator[](int n) const {
    if (n < support_.first || n > support_.last) return std::nullopt;
    return values_[static_cast<std::size_t>(n - support_.first)];
  }

 private:
  IndexRange support_;
  std::vector<double> values_;
};

/// A column of more rows than this, zeros included, or whose indices lie farther apart is under no
/// convention that could be recognised, for no filter has nearly so many values.
constexpr std::size_t most_entries = 2000;
constexpr int widest_range = 10'000;

/// How many entries may be misprints.
int exceptions(std::size_t entries) {
  return entries <= 3 ? 0 : std::max(1, static_cast<int>(entries) / 8);
}

/// How a candidate fits the entries; not counted on where too many are wrong.
struct Fit {
  int wrong = 0;
  int weighty = 0;  ///< right entries that are larger than ten times the tolerance
};

Fit fit(const std::vector<EntryToPlace>& entries, const Samples& samples,
        const Convention& convention, double tolerance) {
  Fit result;
  const double scale = power_of_root_two(convention.half_powers);
  for (const EntryToPlace& entry : entries) {
    const int n = entry.index.integer();
    const auto value = samples[source(convention, samples.support(), n)];
    const double expected = value ? sign(convention, n) * scale * *value : 0;
    const double allowed = std::max(entry.unit, tolerance);
    const bool fits = std::abs(entry.value - expected) <= allowed && (value || entry.value == 0);
    if (!fits && ++result.wrong > exceptions(entries.size())) break;
    if (fits && std::abs(expected) > 10 * allowed) ++result.weighty;
  }
  return result;
}

bool explains(const Fit& fit, std::size_t entries) {
  return fit.wrong <= exceptions(entries) && fit.weighty >= 2;
}

/// The least and the largest index.
IndexRange range_of(const std::vector<EntryToPlace>& entries) {
  IndexRange range{entries.front().index.integer(), entries.front().index.integer()};
  for (const EntryToPlace& entry : entries) {
    range.first = std::min(range.first, entry.index.integer());
    range.last = std::max(range.last, entry.index.integer());
  }
  return range;
}

/// Conventions of the given signs and order, the shifts in between from the smallest on.
std::vector<int> shifts(const std::vector<EntryToPlace>& entries, bool reversed,
                        IndexRange support) {
  const auto [least, most] = range_of(entries);
  // Source indices must be able to lie inside the support, up to the zeros of a padded table.
  const int slack = std::max(0, (most - least) - (support.last - support.first)) + 1;
  const int centre = reversed ? support.first + support.last : 0;
  const int low = reversed ? support.first - centre + least : support.first - least;
  const int high = reversed ? support.last - centre + most : support.last - most;
  std::vector<int> result;
  for (int s = std::min(low, high) - slack; s <= std::max(low, high) + slack; ++s) {
    result.push_back(s);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](int a, int b) { return std::abs(a) < std::abs(b); });
  return result;
}

bool agrees_with(const Convention& candidate, const std::optional<StatedConvention>& stated) {
  if (!stated) return true;
  const Convention& said = stated->convention;
  return candidate.reversed == said.reversed && candidate.negated == said.negated &&
         candidate.alternating == said.alternating && candidate.exchanged == said.exchanged &&
         candidate.half_powers == said.half_powers &&
         (!stated->shift || candidate.shift == *stated->shift);
}

/// Every combination but for the shift, the simplest first.
std::vector<Convention> candidates() {
  std::vector<Convention> result;
  for (const bool dual : {false, true}) {
    for (const int half_powers : {0, 1, -1, 2, -2}) {
      for (const bool alternating : {false, true}) {
        for (const bool reversed : {false, true}) {
          for (const bool negated : {false, true}) {
            result.push_back({reversed, negated, alternating, dual, 0, half_powers, false});
          }
        }
      }
    }
  }
  const auto complexity = [](const Convention& c) {
    return int(c.reversed) + int(c.negated) + 2 * int(c.alternating) + 3 * int(c.exchanged) +
           int(c.half_powers != 0);
  };
  std::stable_sort(result.begin(), result.end(), [&](const Convention& a, const Convention& b) {
    return complexity(a) < complexity(b);
  });
  return result;
}

double tolerance_for(const std::vector<EntryToPlace>& entries) {
  double largest = 0;
  for (const EntryToPlace& entry : entries) largest = std::max(largest, std::abs(entry.value));
  return 1e-4 * largest;
}

int whole_shift(std::string_view text) {
  const EntryIndex shift = parse_entry_index(text);
  if (shift.is_integer()) return shift.integer();
  throw std::invalid_argument("the shift " + excerpt(text) +
                              " of the convention must be a whole number");
}

/// The powers of sqrt(2) in "*sqrt2", "/2" and their products.
int stated_factor(std::string_view text) {
  const Quantity quantity = parse_quantity("h" + std::string(text));
  if (quantity.divided_by_first) {
    throw std::invalid_argument("the factor " + excerpt(text) +
                                " of the convention must be a product of *sqrt2, /sqrt2, *2, /2");
  }
  return quantity.half_powers;
}

}  // namespace

bool Convention::is_the_librarys() const {
  return !reversed && !negated && !alternating && !exchanged && shift == 0 && half_powers == 0;
}

StatedConvention parse_convention(std::string_view text) {
  StatedConvention result;
  Convention& convention = result.convention;
  convention.stated = true;
  for (std::string_view rest = text; !rest.empty();) {
    const auto end = std::min(rest.find(','), rest.size());
    const std::string_view word = io::trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (word == "reversed") {
      convention.reversed = true;
    } else if (word == "negated") {
      convention.negated = true;
    } else if (word == "alternating") {
      convention.alternating = true;
    } else if (word == "dual") {
      convention.exchanged = true;
    } else if (word == "from 0") {
      result.from_zero = true;
    } else if (word.starts_with("shift ")) {
      result.shift = convention.shift = whole_shift(io::trimmed(word.substr(6)));
    } else if (word.starts_with('*') || word.starts_with('/')) {
      convention.half_powers = stated_factor(word);
    } else {
      throw std::invalid_argument(
          "the convention " + excerpt(word) +
          " is unknown; known: reversed, negated, alternating, dual, shift K, from 0, *sqrt2, "
          "/sqrt2, *2, /2");
    }
  }
  return result;
}

Quantity listed_quantity(const Quantity& quantity, const Convention& convention) {
  Quantity result = convention.exchanged ? exchanged(quantity) : quantity;
  result.half_powers += convention.half_powers;
  return result;
}

EntryIndex source_index(FilterValues& filter, const Quantity& quantity,
                        const Convention& convention, const EntryIndex& index) {
  if (convention.is_the_librarys() || !has_conventions(quantity)) return index;
  const Quantity listed = listed_quantity(quantity, convention);
  return EntryIndex(source(convention, support_of(filter, listed), index.integer()));
}

TrueValue conventional_value(FilterValues& filter, const Quantity& quantity,
                             const Convention& convention, const EntryIndex& index) {
  if (convention.is_the_librarys()) return filter.value(quantity, index);
  Quantity listed = listed_quantity(quantity, convention);
  const EntryIndex place = source_index(filter, quantity, convention, index);
  if (sign(convention, index.integer()) < 0) listed.negated = !listed.negated;
  return filter.value(listed, place);
}

std::optional<Convention> recognise_convention(FilterValues& filter, const Quantity& quantity,
                                               const std::vector<EntryToPlace>& entries,
                                               const std::optional<StatedConvention>& stated) {
  if (!has_conventions(quantity) || entries.size() < 2) return std::nullopt;
  const IndexRange range = range_of(entries);
  if (entries.size() > most_entries || range.last - range.first > widest_range) return std::nullopt;
  const double tolerance = tolerance_for(entries);
  const Samples own(filter, quantity);
  if (!stated && explains(fit(entries, own, {}, tolerance), entries.size())) return std::nullopt;
  std::optional<Samples> dual;
  for (Convention candidate : candidates()) {
    if (!agrees_with(candidate, stated)) continue;
    const bool needs_dual = candidate.exchanged;
    if (needs_dual && (filter.is_orthonormal() || quantity.factors.empty())) continue;
    try {
      if (needs_dual && !dual) dual.emplace(filter, exchanged(quantity));
    } catch (const std::domain_error&) {  // the dual functions have no such integrals
      continue;
    }
    const Samples& samples = needs_dual ? *dual : own;
    for (const int shift : shifts(entries, candidate.reversed, samples.support())) {
      candidate.shift = shift;
      if (!agrees_with(candidate, stated)) continue;
      if (!explains(fit(entries, samples, candidate, tolerance), entries.size())) continue;
      candidate.stated = stated.has_value();
      return candidate;
    }
  }
  return std::nullopt;
}

std::string describe(FilterValues& filter, const Quantity& quantity, const Convention& convention) {
  std::vector<std::string> words;
  const IndexRange support = support_of(filter, listed_quantity(quantity, convention));
  if (convention.reversed) words.push_back("reversed");
  const int of_zero = source(convention, support, 0);
  if (convention.shift != 0) {
    const bool from_zero = of_zero == (convention.reversed ? support.last : support.first);
    words.push_back(from_zero ? "from 0" : fmt::format("shift {}", convention.shift));
  }
  if (convention.negated) words.push_back("negated");
  if (convention.alternating) words.push_back("alternating");
  if (convention.exchanged) words.push_back("dual");
  if (convention.half_powers != 0) words.push_back(factor_text(convention.half_powers));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string known_as(FilterValues& filter, const Quantity& quantity, const Convention& convention) {
  if (quantity.family->name != "h" || quantity.negated || quantity.half_powers != 0) return "";
  if (convention.half_powers != 0 || convention.alternating) return "";
  const Quantity listed = listed_quantity(quantity, convention);
  const certified::BasisFunction& f = listed.factors.front().function;
  const bool analysis = f.dual || filter.is_orthonormal();
  const bool synthesis = !f.dual;
  // The signs of the two high-pass filters follow the parity of the first analysis index.
  const bool odd = support_of(filter, parse_quantity("dual(h)")).first % 2 != 0;
  const bool expected_sign = f.wavelet && odd;
  if (convention.negated != expected_sign) return "";
  if (convention.reversed && analysis) {
    return f.wavelet ? "PyWavelets dec_hi, MATLAB HiD" : "PyWavelets dec_lo, MATLAB LoD";
  }
  if (!convention.reversed && synthesis) {
    return f.wavelet ? "PyWavelets rec_hi, MATLAB HiR" : "PyWavelets rec_lo, MATLAB LoR";
  }
  return "";
}

}  // namespace wavecurve::verification
