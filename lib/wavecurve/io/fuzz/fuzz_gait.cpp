#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "wavecurve/io/files/detail/fuzzed_file_test.hpp"
#include "wavecurve/io/tracks/gait_parameters_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const wavecurve::io::FuzzedFile file(bytes, size);
  try {
    wavecurve::io::read_gait_parameters(file.path());
  } catch (const std::invalid_argument&) {
  } catch (const std::domain_error&) {
  }
  return 0;
}
