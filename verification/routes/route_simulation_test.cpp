// How often the search for routes is wrong, and how often it finds what is there: tables are made
// without a route, from true values and noise of every level, and by every route.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "wavecurve/certified/rounding.hpp"

#include "verification/quantities/filter_values.hpp"
#include "verification/routes/print_rules.hpp"
#include "verification/routes/route_chance.hpp"
#include "verification/routes/table_routes.hpp"

namespace wavecurve::verification {
namespace {

using certified::Ball;
using certified::Rational;

// --- the interval of a rate ---

/// The probability p for which `tail`, which increases with p, is 2.5 %.
double solve(const std::function<double(double p)>& tail) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double p = (low + high) / 2;
    (tail(p) < 0.025 ? low : high) = p;
  }
  return low;
}

/// P(X <= k), X binomial.
double at_most(int k, int n, double p) {
  double sum = 0;
  for (int i = 0; i <= k; ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(p) + (n - i) * std::log1p(-p));
  }
  return sum;
}

struct Interval {
  double low = 0, high = 1;
};

/// Clopper and Pearson's 95 % interval for k of n.
Interval interval_of(int k, int n) {
  return {k == 0 ? 0 : solve([=](double p) { return 1 - at_most(k - 1, n, p); }),
          k == n ? 1 : 1 - solve([=](double q) { return at_most(k, n, 1 - q); })};
}

TEST(RouteSimulation, IntervalsAreThoseOfClopperAndPearson) {
  EXPECT_NEAR(interval_of(0, 100).high, 1 - std::pow(0.025, 0.01), 1e-9);
  EXPECT_NEAR(interval_of(100, 100).low, std::pow(0.025, 0.01), 1e-9);
  EXPECT_NEAR(interval_of(5, 10).low, 0.187086, 1e-6);
  EXPECT_NEAR(interval_of(5, 10).high, 0.812914, 1e-6);
}

// --- what tables are made of ---

constexpr int known_decimals = 90;  ///< of the numbers that stand for the true ones

/// A column of a filter with all its routes, found once and used for many prints.
struct Source {
  std::string name;
  Quantity quantity;
  std::unique_ptr<FilterValues> filter;
  std::vector<Rational> values;
  std::vector<Route> routes;
  std::size_t print_rules = 0;  ///< how many of the routes, the first, need the true values alone
};

Rational known(const TrueValue& value) { return round_to_decimals(value, known_decimals)->value(); }

Source make_source(const std::string& name, const Quantity& quantity) {
  Source source{name, quantity, std::make_unique<FilterValues>(find_table_filter(name)), {}, {}, 0};
  FilterValues& filter = *source.filter;
  RouteInput input;
  std::vector<TrueValue> values;
  for (int i = 0; i < filter.number_of_taps(); ++i) {
    const int n = filter.first_tap() + i;
    input.taps.push_back(filter.value(Quantity::taps, n));
    values.push_back(filter.value(quantity, is_taps(quantity) ? n : i));
    source.values.push_back(known(values.back()));
  }
  input.published_taps = find_published_taps(filter.name());
  input.orthonormal = filter.is_orthonormal();
  source.routes = print_rules(values);
  source.print_rules = source.routes.size();
  auto others = run_routes(quantity, input);
  std::move(others.begin(), others.end(), std::back_inserter(source.routes));
  return source;
}

/// Columns of all families and kinds of quantities; the last three have a thousand routes each.
std::vector<Source> make_sources() {
  std::vector<Source> sources;
  const std::vector<std::pair<const char*, Quantity>> all{{"db2", Quantity::taps},
                                                          {"db3", Quantity::taps_sum_2},
                                                          {"db4", Quantity::taps_sum_1},
                                                          {"db5", Quantity::taps},
                                                          {"db7", Quantity::taps_sum_2},
                                                          {"db10", Quantity::taps},
                                                          {"db19", Quantity::taps},
                                                          {"sym4", Quantity::taps_sum_2},
                                                          {"sym6", Quantity::taps},
                                                          {"sym9", Quantity::taps_sum_1},
                                                          {"coif1", Quantity::taps},
                                                          {"coif2", Quantity::taps},
                                                          {"coif3", Quantity::taps_sum_2},
                                                          {"coif4", Quantity::taps},
                                                          {"bspline2.2", Quantity::taps_sum_2},
                                                          {"bspline3.5", Quantity::taps},
                                                          {"cdf9.7", Quantity::taps_sum_1},
                                                          {"coif1", Quantity::autocorrelation},
                                                          {"db5", Quantity::autocorrelation},
                                                          {"db4", Quantity::mu_normalized},
                                                          {"coif2", Quantity::nu_normalized},
                                                          {"sym5", Quantity::mu}};
  for (const auto& [name, quantity] : all) sources.push_back(make_source(name, quantity));
  return sources;
}

Rational from_double(double x) { return *exactly(x).exact; }

/// A number as it is printed, correctly rounded or cut off.
PrintedNumber printed(const Rational& number, int decimals, Printing printing) {
  const Rational half_unit = power_of_ten(-decimals) / Rational(2);
  Rational shifted = number;
  if (printing == Printing::cut_off) {
    shifted = number.abs() <= half_unit ? Rational(0)
              : number.sign() < 0       ? number + half_unit
                                        : number - half_unit;
  }
  return parse_printed_number(certified::round_to_decimals(shifted, decimals));
}

EntryToExplain entry_of(const Source& source, std::size_t place, const PrintedNumber& print) {
  const Rational error = (print.value() - source.values[place]).abs() / print.unit();
  return {place, print, std::nullopt, error > Rational(1, 2), Ball(error).to_double()};
}

bool something_is_wrong(const std::vector<EntryToExplain>& entries) {
  return std::any_of(entries.begin(), entries.end(),
                     [](const EntryToExplain& entry) { return entry.wrong; });
}

class Simulation : public testing::Test {
 protected:
  int integer(int first, int last) { return std::uniform_int_distribution(first, last)(random_); }
  double real(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  /// The shorter of two: most tables are short, and chance explains a short one sooner. Those with
  /// a thousand routes, the last ones, take the time of many others, and are drawn less often.
  const Source& any_source() {
    const int last = static_cast<int>(sources_.size()) - (integer(0, 7) > 0 ? 4 : 1);
    const Source& a = sources_[static_cast<std::size_t>(integer(0, last))];
    const Source& b = sources_[static_cast<std::size_t>(integer(0, last))];
    return a.values.size() < b.values.size() ? a : b;
  }

  /// True values and noise of one level: on all entries, on some, or relative to the entry.
  std::vector<EntryToExplain> noise(const Source& source, int decimals) {
    const double level = std::pow(10.0, real(-0.3, 6.0));
    const int kind = integer(0, 2);
    double largest = 0;
    for (const Rational& value : source.values) {
      largest = std::max(largest, std::abs(Ball(value).to_double()));
    }
    std::vector<EntryToExplain> entries;
    for (std::size_t i = 0; i < source.values.size(); ++i) {
      double error = real(-level, level);
      if (kind == 1 && integer(0, 3) > 0) error = 0;
      if (kind == 2) error *= std::abs(Ball(source.values[i]).to_double()) / largest;
      const Rational number = source.values[i] + from_double(error) * power_of_ten(-decimals);
      entries.push_back(entry_of(source, i, printed(number, decimals, Printing::rounded)));
    }
    return entries;
  }

  /// A column made by the route; of every third long enough, one number is miscomputed.
  std::vector<EntryToExplain> made_by(const Source& source, const Route& route, int decimals) {
    constexpr int long_enough = 8;
    const int size = static_cast<int>(source.values.size());
    const bool damaged = size >= long_enough && integer(0, 2) == 0;
    const int where = integer(0, size - 1);
    const bool in_double = route.rounding_errors && !route.exact.empty();
    const Eigen::VectorXd bounds = in_double ? route.rounding_errors() : Eigen::VectorXd();
    std::vector<EntryToExplain> entries;
    for (int i = 0; i < size; ++i) {
      const auto place = static_cast<std::size_t>(i);
      Rational number = known(route.value(place));
      // Another program's rounding errors are anything within the bounds.
      if (in_double) number += from_double(bounds[i] * real(-1, 1));
      if (damaged && i == where) number += from_double(real(-50, 50)) * power_of_ten(-decimals);
      entries.push_back(entry_of(source, place, printed(number, decimals, route.printing)));
    }
    return entries;
  }

  const std::vector<Source> sources_ = make_sources();
  std::mt19937_64 random_{20240519};
};

/// Scores, habits and credits of a table of these columns.
std::vector<std::optional<CreditedRoute>> credited(const std::vector<ColumnScores>& columns) {
  return credit_routes(columns, find_habits(columns));
}

ColumnScores scores_of(const Source& source, const std::vector<EntryToExplain>& entries) {
  return something_is_wrong(entries) ? score_routes(entries, source.routes)
                                     : ColumnScores{score_of_true_values(entries)};
}

void print_rate(const char* what, int k, int n) {
  const auto [low, high] = interval_of(k, n);
  std::printf("%s: %d of %d, 95 %% interval %.6f .. %.6f\n", what, k, n, low, high);
}

TEST_F(Simulation, CreditsNoColumnThatNoRouteMade) {
  constexpr int tables = 9300, columns_of_a_table = 4;
  int columns = 0, false_routes = 0;
  for (int table = 0; table < tables; ++table) {
    const int decimals = integer(6, 60);
    std::vector<ColumnScores> scores;
    for (int c = 0; c < columns_of_a_table; ++c) {
      const Source& source = any_source();
      scores.push_back(scores_of(source, noise(source, decimals)));
    }
    for (std::size_t c = 0; const auto& credit : credited(scores)) {
      ++columns;
      false_routes += credit ? 1 : 0;
      if (credit) {
        ADD_FAILURE() << scores[c][credit->route].name << " at " << decimals << " decimals, "
                      << scores[c][credit->route].matched << " of "
                      << scores[c][0].yields_print.size() << " entries";
      }
      ++c;
    }
  }
  print_rate("columns of noise credited to a route", false_routes, columns);
  EXPECT_LT(interval_of(false_routes, columns).high, 1e-4);
}

/// How far a route's number has to be from the true value, in last units, for its print to tell:
/// half a unit, and three times what rounding errors may be (as much may be allowed for as half the
/// distance between print and true value).
bool is_visible(const Source& source, const Route& route, int decimals) {
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(route.doubles.size());
  if (route.rounding_errors && !route.exact.empty()) errors = route.rounding_errors();
  int visible = 0;
  for (std::size_t i = 0; i < source.values.size(); ++i) {
    const double unit = std::pow(10.0, -decimals);
    const double error =
        i < static_cast<std::size_t>(errors.size()) ? errors[static_cast<Eigen::Index>(i)] : 0;
    const Rational change = (known(route.value(i)) - source.values[i]).abs();
    visible += Ball(change).to_double() > unit / 2 + 3 * error ? 1 : 0;
  }
  return 8 * visible >= 7 * static_cast<int>(source.values.size());
}

TEST_F(Simulation, FindsTheRoutesThatTablesWereMadeBy) {
  constexpr int tables = 300;
  constexpr std::size_t entries_of_a_table = 120;
  int planted = 0, found = 0, others = 0;
  for (int table = 0; table < tables; ++table) {
    const Source& first = any_source();
    const auto route_number =
        static_cast<std::size_t>(integer(0, static_cast<int>(first.routes.size()) - 1));
    // Rules that need the true values alone are few of hundreds: every fourth table is theirs.
    const std::string name =
        first.routes[table % 4 == 0 ? route_number % first.print_rules : route_number].name;
    std::vector<ColumnScores> scores;
    std::size_t entries_so_far = 0;
    const int decimals = integer(6, 60);
    for (int attempt = 0; attempt < 40 && entries_so_far < entries_of_a_table; ++attempt) {
      const Source& source = attempt == 0 ? first : any_source();
      const auto route = std::find_if(source.routes.begin(), source.routes.end(),
                                      [&](const Route& r) { return r.name == name; });
      if (route == source.routes.end() || !(route->doubles.cwiseAbs().maxCoeff() < 1e3)) continue;
      // Cut off is what any number may be; other routes have to change the numbers.
      const bool shows =
          route->printing == Printing::cut_off || is_visible(source, *route, decimals);
      if (!shows) continue;
      const auto entries = made_by(source, *route, decimals);
      scores.push_back(scores_of(source, entries));
      entries_so_far += entries.size();
    }
    for (std::size_t c = 0; const auto& credit : credited(scores)) {
      const ColumnScores& column = scores[c++];
      const auto made_by = std::find_if(column.begin(), column.end(), [&](const RouteScore& score) {
        return score.name == name;
      });
      if (made_by == column.end()) continue;  // nothing in the column is wrong
      ++planted;
      if (!credit) continue;
      // Several routes may yield the same digits; one that yields fewer is another.
      (column[credit->route].matched >= made_by->matched ? found : others) += 1;
    }
  }
  print_rate("columns made by a route and credited to it", found, planted);
  print_rate("columns made by a route and credited to one that yields less", others, planted);
  EXPECT_GT(interval_of(found, planted).low, 0.95);
  EXPECT_EQ(others, 0);
}

}  // namespace
}  // namespace wavecurve::verification
