// Writes docs/atlas.md from the tables of verification/published/atlas.
#include <exception>
#include <iostream>
#include <stdexcept>

#include "wavecurve/io/files/write_file.hpp"

#include "verification/checker/atlas.hpp"

int main(int count, char** arguments) try {
  using namespace wavecurve;
  if (count != 3) {
    std::cerr << "usage: generate_atlas FOLDER OUT.md\n";
    return 2;
  }
  io::write_file(arguments[2], verification::atlas_page(verification::judge_atlas(arguments[1])));
  return 0;
} catch (const std::invalid_argument& error) {
  std::cerr << "generate_atlas: " << error.what() << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << "generate_atlas: " << error.what() << '\n';
  return 3;
}
