#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/certified/rational.hpp"

#include "verification/tables/published_table.hpp"

namespace wavecurve::verification {

/// The taps of a filter as another publication prints them.
struct PublishedTaps {
  std::string name;  ///< the title of the table
  std::vector<certified::Rational> numbers;
  Quantity normalization;

  /// Brought to the sum sqrt 2, in double precision.
  Eigen::VectorXd taps() const;
};

/// Looks through the files taps_*.csv of published/ (data_folder.hpp), tables of the checker's form.
/// Nothing if none lists taps of the filter (canonical name). To add one, add a file.
std::optional<PublishedTaps> find_published_taps(std::string_view filter);

}  // namespace wavecurve::verification
