#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "verification/tables/published_table.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    const auto table = wavecurve::verification::parse_published_table(text, "t.csv");
    if (table.entries.empty()) std::abort();
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
