#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "verification/quantities/convention.hpp"
#include "verification/quantities/integral_expression.hpp"
#include "verification/quantities/quantity.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace wavecurve::verification;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  try {
    // What a quantity is called is understood as that quantity.
    const Quantity quantity = parse_quantity(text);
    if (parse_quantity(to_string(quantity)) != quantity) std::abort();
  } catch (const std::invalid_argument&) {
  }
  try {
    const auto integral = parse_integral(text);
    if (name_of(parse_integral(to_string(integral))) != name_of(integral)) std::abort();
  } catch (const std::invalid_argument&) {
  }
  try {
    parse_interval(text);
  } catch (const std::invalid_argument&) {
  }
  try {
    parse_convention(text);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
