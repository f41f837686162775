#include "wavecurve/io/animations/detail/png.hpp"

#include <png.h>
#include <stdexcept>

namespace wavecurve::io {

std::string png(const Raster& raster) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(raster.width);
  image.height = static_cast<png_uint_32>(raster.height);
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, raster.rgba.data(), 0, nullptr)) {
    throw std::runtime_error(std::string("cannot make a PNG file: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace wavecurve::io
