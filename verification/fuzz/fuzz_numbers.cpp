#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "verification/identify/number_lists.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    for (const auto& list : wavecurve::verification::read_number_lists(text)) {
      if (list.numbers.empty()) std::abort();
    }
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
