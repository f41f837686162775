#pragma once

#include <string>

#include "reports/figures.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::reports {

/// One piece of evidence as HTML; each figure is followed by the table of its numbers.
/// `figures` as in to_html; `table_id` makes the table's caption a label of its own; `folder` is
/// where the figures' files lie.
std::string html_of(const verification::Evidence& evidence, const Figures& figures,
                    const std::string& table_id, const std::string& folder = "figures");

}  // namespace wavecurve::reports
