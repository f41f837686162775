#pragma once

#include <string>

#include "wavecurve/io/animations/raster.hpp"

namespace wavecurve::io {

/// The bytes of a PNG file.
std::string png(const Raster& raster);

}  // namespace wavecurve::io
