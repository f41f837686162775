// The stiffness matrix of periodized wavelets, int b_i'(x) b_j'(x) dx, and its first eigenvalues,
// which tend to (2 pi n)^2. Prints:
//   110769 entries
//   39.478
//   39.478
//   157.914
//   157.914
#include <cstdio>
#include <wavecurve/wavecurve.hpp>

#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>

int main() {
  const auto bank = wavecurve::find_filter_bank("db4");
  const auto stiffness = wavecurve::stiffness(bank, 1024, 10);  // Eigen::SparseMatrix<double>
  std::printf("%d entries\n", static_cast<int>(stiffness.nonZeros()));

  Spectra::SparseSymShiftSolve<double> inverse(stiffness);  // of K - sigma I
  Spectra::SymEigsShiftSolver solver(inverse, 5, 20, -1.0);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn);
  const Eigen::VectorXd eigenvalues = solver.eigenvalues();  // the last is 0, of the constants
  for (int i = 3; i >= 0; --i) std::printf("%.3f\n", eigenvalues[i]);
}
