#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace wavecurve::verification {

/// The taps of a filter as another publication prints them, brought to the sum sqrt 2.
struct PublishedTaps {
  std::string name;  ///< the title of the table
  Eigen::VectorXd taps;
};

/// Looks through the files taps_*.csv of published/ (data_folder.hpp), tables of the checker's form.
/// Nothing if none lists every tap of the filter (canonical name). To add one, add a file.
std::optional<PublishedTaps> find_published_taps(std::string_view filter);

}  // namespace wavecurve::verification
