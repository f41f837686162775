#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/prints/print_form.hpp"
#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

/// A part of a print, which departs from the right number or does not. Where a sign is missing, an
/// empty part departs.
struct PrintPart {
  std::string text;
  bool departs = false;

  bool operator==(const PrintPart&) const = default;
};

/// The text of a print cut where it departs, so that the parts put together are the text: a wrong sign,
/// and the digits of the mantissa from the first wrong one to the last. `number` is what the text was read
/// as. A fraction departs as a whole, and so does a text whose digits are not those of the number.
std::vector<PrintPart> marked_print(const std::string& text, const PrintedNumber& number,
                                    const std::optional<Departure>& departure);

}  // namespace wavecurve::verification
