#include "wavecurve/operators/multiscale_matrix.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/detail/strided_block.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {

namespace {

/// r_n = 2^d sum_{m,i} wavelet_m scaling_i mu_{2n + m - i} = int psi^(p)(x - n) phi^(q)(x) dx.
Filter<double> same_level(const Filter<double>& wavelet, const Filter<double>& scaling,
                          const Filter<double>& mu, int d) {
  const int first = floor_half(mu.first_index - wavelet.last_index() + scaling.first_index);
  const int last = floor_half(mu.last_index() - wavelet.first_index + scaling.last_index());
  Filter<double> result{first, {}};
  for (int n = first; n <= last; ++n) {
    double sum = 0;
    for (int m = wavelet.first_index; m <= wavelet.last_index(); ++m) {
      for (int i = scaling.first_index; i <= scaling.last_index(); ++i) {
        sum += wavelet[m] * scaling[i] * mu[2 * n + m - i];
      }
    }
    result.taps.push_back(std::ldexp(sum, d));
  }
  return result;
}

/// One more level between coarse and fine: r_n = 2^d sum_i taps_i previous_{n - stride i}, by the
/// two-scale relation of the coarse function.
Filter<double> widen(const Filter<double>& previous, const Filter<double>& taps, int stride,
                     int d) {
  const auto size = static_cast<std::size_t>(previous.size() + stride * (taps.size() - 1));
  Filter<double> result{previous.first_index + stride * taps.first_index,
                        std::vector<double>(size)};
  for (int i = 0; i < taps.size(); ++i) {
    const double weight = std::ldexp(taps.taps[static_cast<std::size_t>(i)], d);
    double* target = result.taps.data() + stride * i;
    for (double value : previous.taps) *target++ += weight * value;
  }
  return result;
}

/// Places the blocks of all pairs of bands, diagonals of equal level difference at a time.
class BlockGrid {
 public:
  BlockGrid(std::vector<Band> bands, int finest_level, int d)
      : bands_(std::move(bands)), finest_level_(finest_level), d_(d) {
    blocks_.assign(bands_.size(), std::vector<StridedBlock>(bands_.size()));
  }

  void set_diagonal(std::size_t band, const Filter<double>& coefficients) {
    const Eigen::VectorXd column = circulant_column(coefficients, bands_[band].size, d_);
    place(band, band, StridedBlock::with_fine_rows(column, bands_[band].size));
  }

  /// Both blocks of a coarse and a fine band; r_n = int fine_n^(p) coarse_0^(q) on the unit grid of
  /// the coarse level. Partial integration moves the derivatives at the cost of the sign (-1)^d.
  void set_pair(std::size_t coarse, std::size_t fine, const Filter<double>& r) {
    const int level = finest_level_ - bands_[coarse].depth;
    const Eigen::VectorXd generator =
        std::ldexp(1.0, level * d_) * plain::periodized(r, bands_[fine].size);
    const double sign = d_ % 2 == 0 ? 1 : -1;
    place(coarse, fine, StridedBlock::with_fine_rows(generator, bands_[coarse].size));
    place(fine, coarse, StridedBlock::with_fine_columns(sign * generator, bands_[coarse].size));
  }

  Eigen::SparseMatrix<double> assembled() const { return assemble(blocks_); }

 private:
  void place(std::size_t column, std::size_t row, StridedBlock block) {
    check_non_zeros(non_zeros_ += block.non_zeros());  // before memory runs out
    blocks_[column][row] = std::move(block);
  }

  std::vector<Band> bands_;
  int finest_level_, d_;
  Eigen::Index non_zeros_ = 0;
  std::vector<std::vector<StridedBlock>> blocks_;  ///< [column][row]
};

Eigen::SparseMatrix<double> identity(Eigen::Index size) {
  Eigen::SparseMatrix<double> result(size, size);
  result.setIdentity();
  return result;
}

}  // namespace

Eigen::SparseMatrix<double> multiscale_matrix(const FilterBank<double>& bank,
                                              const ConnectionCoefficients<double>& coefficients,
                                              Eigen::Index samples, int levels) {
  const int finest_level = checked_log2(samples);
  const int d = coefficients.p + coefficients.q;
  const std::vector<Band> bands = multiscale_bands(samples, levels);
  const auto wavelets = static_cast<std::size_t>(levels);
  BlockGrid grid(bands, finest_level, d);
  // A single scaling function is the constant, whose derivatives vanish: no rounding in their
  // place.
  const bool constant = bands.front().size == 1 && d > 0;
  const auto place_scaling = [&](std::size_t fine, const Filter<double>& r) {
    grid.set_pair(0, fine, constant ? Filter<double>{} : r);
  };
  grid.set_diagonal(0, constant ? Filter<double>{} : coefficients.mu);
  for (std::size_t band = 1; band <= wavelets; ++band) grid.set_diagonal(band, coefficients.nu);
  // Bands 0 and 1 are on the same level, band i + 1 is one level finer than band i.
  Filter<double> scaling =
      levels == 0 ? Filter<double>{}
                  : same_level(bank.synthesis_high, bank.synthesis_low, coefficients.mu, d);
  for (std::size_t delta = 0; delta < wavelets; ++delta) {
    place_scaling(1 + delta, scaling);
    if (delta + 1 == wavelets) break;
    const int stride = 1 << delta;
    const Filter<double> wavelet = widen(scaling, bank.synthesis_high, stride, d);
    for (std::size_t coarse = 1; coarse + delta + 1 <= wavelets; ++coarse) {
      grid.set_pair(coarse, coarse + delta + 1, wavelet);
    }
    scaling = widen(scaling, bank.synthesis_low, stride, d);
  }
  return grid.assembled();
}

Eigen::SparseMatrix<double> multiscale_matrix(const FilterBank<double>& bank, Eigen::Index samples,
                                              int levels, int p, int q) {
  return multiscale_matrix(bank, connection_coefficients(bank, p, q), samples, levels);
}

Eigen::SparseMatrix<double> stiffness(const FilterBank<double>& bank, Eigen::Index samples,
                                      int levels) {
  return multiscale_matrix(bank, samples, levels, 1, 1);
}

Eigen::SparseMatrix<double> gram(const FilterBank<double>& bank, Eigen::Index samples, int levels) {
  if (!bank.is_orthonormal()) return multiscale_matrix(bank, samples, levels, 0, 0);
  checked_log2(samples);
  multiscale_bands(samples, levels);
  return identity(samples);
}

Eigen::SparseMatrix<double> damping(const FilterBank<double>& bank, Eigen::Index samples,
                                    int levels, double s1, double s2) {
  return s1 * gram(bank, samples, levels) + s2 * stiffness(bank, samples, levels);
}

}  // namespace wavecurve

namespace wavecurve::plain {

Eigen::MatrixXd multiscale_matrix(const FilterBank<double>& bank,
                                  const ConnectionCoefficients<double>& coefficients,
                                  Eigen::Index samples, int levels) {
  const Eigen::VectorXd column =
      circulant_column(coefficients.mu, samples, coefficients.p + coefficients.q);
  Eigen::MatrixXd circulant(samples, samples), synthesis(samples, samples);
  for (Eigen::Index j = 0; j < samples; ++j) {
    for (Eigen::Index i = 0; i < samples; ++i) {
      circulant(i, j) = column[(i - j + samples) % samples];
    }
    synthesis.col(j) = inverse_transform(bank, levels, Eigen::VectorXd::Unit(samples, j));
  }
  return synthesis.transpose() * circulant * synthesis;
}

}  // namespace wavecurve::plain
