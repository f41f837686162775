// The taps of a filter, each the double nearest to the true value. Prints:
//   cdf9.7: 4 vanishing moments, Sobolev exponent 2.123
//   -3  -0.0645388826289384
//   -2  -0.0406894176095584
//   -1  +0.4180922732222122
//   +0  +0.7884856164056644
//   +1  +0.4180922732222122
//   +2  -0.0406894176095584
//   +3  -0.0645388826289384
#include <cstdio>
#include <wavecurve/wavecurve.hpp>

int main() {
  const auto bank = wavecurve::find_filter_bank("cdf9.7");  // or "db4", "coif2", "bspline4.4", ...
  std::printf("%s: %d vanishing moments, Sobolev exponent %.3f\n", bank.name.c_str(),
              bank.vanishing_moments, bank.sobolev_exponent);
  const wavecurve::Filter<double>& low = bank.synthesis_low;
  for (int n = low.first_index; n <= low.last_index(); ++n) std::printf("%+d  %+.16f\n", n, low[n]);
}
