#pragma once

#include <string>

namespace wavecurve::certified {

/// The text of lib/wavecurve/filters/filter_tables.cpp: every tap of every tabulated family, each
/// the double and the float nearest to its enclosure, as hexadecimal literals; the Sobolev
/// exponents; the aliases. Written to the file by tools/generate_filter_tables, compared with it by
/// a test.
std::string filter_table_source();

}  // namespace wavecurve::certified
