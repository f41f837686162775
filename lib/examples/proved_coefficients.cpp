// Connection coefficients with proof: mu_l = int phi'(x - l) phi'(x) dx of coif2, correctly rounded
// to 20 digits, and that of db4 as a fraction. Prints:
//   coif2: mu_0 = 4.0722079003268757404
//   coif2: mu_1 = -2.5775864340928501954
//   coif2: mu_2 = 0.68460174023075526651
//   db4:   mu_0 = 342643/82248
#include <cstdio>
#include <wavecurve/certified.hpp>

using namespace wavecurve::certified;

int main() {
  const auto mu = certified_decimals(find_filter("coif2"), {.digits = 20}).mu;
  for (std::size_t l = 0; l <= 2; ++l) std::printf("coif2: mu_%zu = %s\n", l, mu[l].value.c_str());
  const auto exact = certified_decimals(find_filter("db4"), {.digits = 20}).mu[0].exact;
  std::printf("db4:   mu_0 = %s\n", exact->c_str());
}
