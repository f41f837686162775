// Writes the double and float tables of all tabulated filters, from certified enclosures:
//   generate_filter_tables lib/wavecurve/filters/filter_tables.cpp
#include <cstdio>
#include <exception>

#include "wavecurve/certified/detail/filter_table_source.hpp"
#include "wavecurve/io/files/write_file.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: generate_filter_tables OUTPUT.cpp\n");
    return 2;
  }
  wavecurve::io::write_file(argv[1], wavecurve::certified::filter_table_source());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "generate_filter_tables: %s\n", error.what());
  return 3;
}
