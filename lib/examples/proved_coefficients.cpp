// Connection coefficients with proof: mu_l = int phi'(x - l) phi'(x) dx of coif2, correctly rounded to
// 20 digits, and that of db4 as a fraction. Prints:
//   coif2: mu_0 = 4.0722079003268757404
//   coif2: mu_1 = -2.5775864340928501954
//   coif2: mu_2 = 0.68460174023075526651
//   db4:   mu_0 = 342643/82248
#include <cstdio>
#include <string>
#include <wavecurve/certified.hpp>

using namespace wavecurve::certified;

/// Correctly rounded, with as many bits as it takes to decide that.
std::string proved_decimal(const FilterDefinition& filter, int l, int digits) {
  for (long bits = 128;; bits *= 2) {
    const WorkingPrecision precision(bits);
    const Ball mu = connection_coefficients(filter, 1, 1, bits).mu[l];
    if (const auto decimal = decimal_enclosure(mu, digits)) return decimal->value;
  }
}

int main() {
  for (int l = 0; l <= 2; ++l) {
    std::printf("coif2: mu_%d = %s\n", l, proved_decimal(find_filter("coif2"), l, 20).c_str());
  }
  const auto exact = exact_connection_coefficients(find_filter("db4"), 1, 1);
  std::printf("db4:   mu_0 = %s\n", decimal_enclosure(exact->mu[0], 20).exact->c_str());
}
