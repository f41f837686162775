#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "wavecurve/io/files/detail/fuzzed_file_test.hpp"

#include "benchmarks/tracking/record.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const wavecurve::io::FuzzedFile file(bytes, size);
  try {
    wavecurve::tracking::read_record(file.path());
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
