#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/tracking/change.hpp"
#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

/// One quantity of one benchmark before and after. `ratio` is after over before, above 1 for worse
/// (of digits: 10^(digits lost)).
struct Row {
  std::string benchmark;
  std::string quantity;  ///< "instructions", "time", "error", "iterations", "digits"
  double before = 0, after = 0;
  RatioInterval ratio{1, 1, 1};
  Change verdict = Change::same;
  std::string note = {};  ///< data references; that an alarm was confirmed, or not
};

/// True if it says that something has become slower or faster.
inline bool is_alarm(const Row& row) {
  return row.verdict == Change::slower || row.verdict == Change::faster;
}

struct Comparison {
  std::string before, after;
  std::vector<Row> rows;
  std::vector<std::string> notes;

  /// The verdict on a benchmark, all its quantities together: slower if one is; what the counts leave the same
  /// is the same though its time is inconclusive.
  Change verdict_of(const std::string& benchmark) const;
  /// 0: no regression, 1: a regression, 4: nothing worse than inconclusive.
  int exit_code() const;
};

/// For a terminal; rows that are the same are left out unless `all`, and then counted.
std::string to_text(const Comparison& comparison, bool all);
/// For a pull request.
std::string to_markdown(const Comparison& comparison);
Json to_json(const Comparison& comparison);

}  // namespace wavecurve::tracking
