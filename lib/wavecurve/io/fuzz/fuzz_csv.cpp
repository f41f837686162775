#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "wavecurve/io/drawings/detail/read_points.hpp"
#include "wavecurve/io/fuzz/check_drawing_test.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    wavecurve::io::check_drawing(wavecurve::io::read_points(text).drawing);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
