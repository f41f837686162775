#pragma once

#include <string>

namespace wavecurve::certified {

/// The text of lib/wavecurve/elementary/detail/elementary_tables.hpp: coefficients, parts of
/// constants, bits of 2/pi, and the bounds of the functions' errors that are proved from them.
/// Written to the file by tools/generate_elementary_tables, compared with it by a test.
std::string elementary_table_source();

}  // namespace wavecurve::certified
