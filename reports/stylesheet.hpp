#pragma once

#include <string_view>

namespace wavecurve::reports {

/// The style of the HTML report, for screens from 320 pixels on, light and dark, and for paper.
std::string_view stylesheet();

}  // namespace wavecurve::reports
