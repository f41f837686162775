// Writes the coefficients of the elementary functions, and proves the bounds of their errors:
//   generate_elementary_tables lib/wavecurve/elementary/detail/elementary_tables.hpp
#include <cstdio>
#include <exception>

#include "wavecurve/certified/detail/elementary/elementary_table_source.hpp"
#include "wavecurve/io/files/write_file.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: generate_elementary_tables OUTPUT.hpp\n");
    return 2;
  }
  wavecurve::io::write_file(argv[1], wavecurve::certified::elementary_table_source());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "generate_elementary_tables: %s\n", error.what());
  return 3;
}
