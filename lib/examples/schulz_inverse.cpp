// Schulz's iteration for the inverse of a damping matrix, with the residuals |I - X_n C| of its
// steps.
// Prints:
//   6.2e+00
//   5.5e+00
//   4.7e+00
//   3.7e+00
//   2.6e+00
//   1.4e+00
//   4.3e-01
//   5.2e-02
//   8.6e-04
//   2.8e-07
//   below 1e-9
//   X is within 1e-8 of the inverse
#include <cstdio>
#include <wavecurve/wavecurve.hpp>

int main() {
  const auto bank = wavecurve::find_filter_bank("coif2");
  const Eigen::MatrixXd c = wavecurve::damping(bank, 64, 6, 1, 1e-4);  // M + 1e-4 K
  const auto result = wavecurve::dynamics::schulz_inverse(c, 1e-9);
  for (const double residual : result.residuals) {
    if (residual >= 1e-9) std::printf("%.1e\n", residual);
    if (residual < 1e-9) std::printf("below 1e-9\n");
  }
  std::printf("%s\n", result.error_bound < 1e-8 ? "X is within 1e-8 of the inverse" : "not proved");
}
