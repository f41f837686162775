#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "verification/suite/claim.hpp"

namespace wavecurve::verification {

/// The outcome of a registered claim. Throws std::out_of_range if there is none of that id.
inline Outcome outcome_of(std::string_view id) {
  const auto found = std::find_if(claims().begin(), claims().end(),
                                  [id](const Claim& claim) { return claim.id == id; });
  if (found == claims().end()) throw std::out_of_range(std::string(id));
  return found->evaluate();
}

/// Expects rows, each with a cell for every column.
inline void expect_full(const Table& table) {
  EXPECT_FALSE(table.rows.empty()) << table.caption;
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.caption;
}

}  // namespace wavecurve::verification
