#pragma once

#include <string>

#include "wavecurve/io/animations/detail/raster.hpp"

namespace wavecurve::io {

/// The bytes of a PNG file.
std::string png(const Raster& raster);

}  // namespace wavecurve::io
