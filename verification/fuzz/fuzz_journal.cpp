#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "verification/study/study_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace wavecurve::verification;
  try {
    // What is read is written so that it is read again as the same.
    const StudyPoint point =
        point_of_json_line(std::string(reinterpret_cast<const char*>(bytes), size));
    const std::string line = to_json_line(point);
    if (to_json_line(point_of_json_line(line)) != line) std::abort();
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
