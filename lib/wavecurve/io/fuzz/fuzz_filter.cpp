#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "wavecurve/io/files/detail/fuzzed_file_test.hpp"
#include "wavecurve/io/filter_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const wavecurve::io::FuzzedFile file(bytes, size);
  try {
    const wavecurve::UserFilter filter = wavecurve::io::read_filter_json(file.path());
    if (filter.taps.taps.empty()) std::abort();
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
