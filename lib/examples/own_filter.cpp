// Your own filter from a JSON file, checked for what it claims: own_filter FILE.json. Its decimals
// are intervals, so every result says how many digits they are worth. From own_filter.json beside
// this file it prints:
//   mine: 6 taps, 3 vanishing moments
//   mu_0 = 5.2678571428571428571 +- 5e-20
#include <cstdio>
#include <exception>
#include <wavecurve/certified.hpp>
#include <wavecurve/io.hpp>

using namespace wavecurve::certified;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FILE.json\n", argv[0]);
    return 2;
  }
  const FilterDefinition filter = wavecurve::io::load_filter(argv[1]);
  const auto bank = wavecurve::io::load_filter_bank(argv[1]);
  std::printf("%s: %d taps, %d vanishing moments\n", filter.name.c_str(), bank.synthesis_low.size(),
              bank.vanishing_moments);
  const WorkingPrecision precision(128);
  const DecimalEnclosure mu =
      supported_decimal(connection_coefficients(filter, 1, 1, 128).mu[0], 20);
  std::printf("mu_0 = %s +- %s\n", mu.value.c_str(), mu.radius.c_str());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
