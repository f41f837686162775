#include "wavecurve/dynamics/modal/detail/modal_basis.hpp"

#include <algorithm>
#include <utility>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/fourier_transform.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::dynamics {

namespace {

long long fourier_operations(Eigen::Index size) {
  return 5 * static_cast<long long>(size) * checked_log2(size);
}

/// Rows k and size - k have the mode first + min(k, size - k).
void append_frequencies(std::vector<int>& modes, Eigen::Index size, Eigen::Index first) {
  for (Eigen::Index k = 0; k < size; ++k) {
    modes.push_back(static_cast<int>(first + std::min(k, size - k)));
  }
}

class FourierBasis : public ModalBasis {
 public:
  FourierBasis(const LagrangeSystem& system, CirculantEigenvalues symbols, std::vector<int> modes)
      : ModalBasis(std::move(symbols), std::move(modes)),
        transform_(system.bank(), system.samples(), system.levels()),
        workspace_(transform_.workspace_size()),
        fine_(system.samples()),
        fourier_(system.samples()) {
    taps_ = system.bank().synthesis_low.size() + system.bank().synthesis_high.size();
  }

  long long operations() const override {
    // Each sample of each level has half of the taps of two filters, for two coordinates.
    return fourier_operations(rows()) + (rows() - (rows() >> transform_.levels())) * 4 * taps_;
  }

 private:
  void to_modes(In first, In second, Column modes) override {
    transform_.inverse(first, fine_, workspace_);
    modes.real() = fine_;
    transform_.inverse(second, fine_, workspace_);
    modes.imag() = fine_;
    fourier_.forward(modes);
  }

  void from_modes(Column modes, Out first, Out second) override {
    fourier_.inverse(modes);
    fine_ = modes.real();
    transform_.forward(fine_, first, workspace_);
    fine_ = modes.imag();
    transform_.forward(fine_, second, workspace_);
  }

  PeriodicTransform<double> transform_;
  Eigen::VectorXd workspace_, fine_;
  FourierTransform fourier_;
  long long taps_ = 0;
};

class BandFourierBasis : public ModalBasis {
 public:
  BandFourierBasis(std::vector<Band> bands, CirculantEigenvalues symbols, std::vector<int> modes)
      : ModalBasis(std::move(symbols), std::move(modes)), bands_(std::move(bands)) {
    for (const Band& band : bands_) fourier_.emplace_back(band.size);
  }

  long long operations() const override {
    long long sum = 0;
    for (const Band& band : bands_) sum += fourier_operations(band.size);
    return sum;
  }

 private:
  void to_modes(In first, In second, Column modes) override {
    modes.real() = first;
    modes.imag() = second;
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      fourier_[i].forward(modes.segment(bands_[i].offset, bands_[i].size));
    }
  }

  void from_modes(Column modes, Out first, Out second) override {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      fourier_[i].inverse(modes.segment(bands_[i].offset, bands_[i].size));
    }
    first = modes.real();
    second = modes.imag();
  }

  std::vector<Band> bands_;
  std::vector<FourierTransform> fourier_;
};

class CoefficientBasis : public ModalBasis {
 public:
  CoefficientBasis(CirculantEigenvalues symbols, std::vector<int> modes)
      : ModalBasis(std::move(symbols), std::move(modes)) {}

  long long operations() const override { return 0; }

 private:
  void to_modes(In first, In second, Column modes) override {
    modes.real() = first;
    modes.imag() = second;
  }
  void from_modes(Column modes, Out first, Out second) override {
    first = modes.real();
    second = modes.imag();
  }
};

CirculantEigenvalues concatenated(const std::vector<CirculantEigenvalues>& parts) {
  const auto join = [&](Eigen::VectorXd CirculantEigenvalues::*member) {
    Eigen::Index size = 0;
    for (const CirculantEigenvalues& part : parts) size += (part.*member).size();
    Eigen::VectorXd result(size);
    Eigen::Index at = 0;
    for (const CirculantEigenvalues& part : parts) {
      result.segment(at, (part.*member).size()) = part.*member;
      at += (part.*member).size();
    }
    return result;
  };
  return {join(&CirculantEigenvalues::gram), join(&CirculantEigenvalues::mass),
          join(&CirculantEigenvalues::damping), join(&CirculantEigenvalues::stiffness)};
}

}  // namespace

ModalBasis::ModalBasis(CirculantEigenvalues modes, std::vector<int> mode_of_row)
    : modes_(std::move(modes)), mode_of_row_(std::move(mode_of_row)) {}

ModalCoefficients ModalBasis::forward(const Eigen::Ref<const Eigen::MatrixXd>& coefficients) {
  ModalCoefficients spectrum(coefficients.rows(), (coefficients.cols() + 1) / 2);
  const bool is_odd = coefficients.cols() % 2 != 0;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(is_odd ? coefficients.rows() : 0);
  for (Eigen::Index j = 0; j < spectrum.cols(); ++j) {
    const bool has_second = 2 * j + 1 < coefficients.cols();
    if (has_second) to_modes(coefficients.col(2 * j), coefficients.col(2 * j + 1), spectrum.col(j));
    if (!has_second) to_modes(coefficients.col(2 * j), none, spectrum.col(j));
  }
  return spectrum;
}

Eigen::MatrixXd ModalBasis::backward(ModalCoefficients spectrum, Eigen::Index coordinates) {
  Eigen::MatrixXd coefficients(spectrum.rows(), coordinates);
  Eigen::VectorXd none(coordinates % 2 != 0 ? spectrum.rows() : 0);
  for (Eigen::Index j = 0; j < spectrum.cols(); ++j) {
    const bool has_second = 2 * j + 1 < coordinates;
    if (has_second) {
      from_modes(spectrum.col(j), coefficients.col(2 * j), coefficients.col(2 * j + 1));
    } else {
      from_modes(spectrum.col(j), coefficients.col(2 * j), none);
    }
  }
  return coefficients;
}

std::unique_ptr<ModalBasis> fourier_basis(const LagrangeSystem& system) {
  std::vector<int> modes;
  modes.reserve(static_cast<std::size_t>(system.samples()));
  append_frequencies(modes, system.samples(), 0);
  return std::make_unique<FourierBasis>(system, system.eigenvalues(), std::move(modes));
}

std::unique_ptr<ModalBasis> band_fourier_basis(const LagrangeSystem& system) {
  std::vector<Band> bands = multiscale_bands(system.samples(), system.levels());
  std::vector<int> modes;
  Eigen::Index first = 0;
  for (const Band& band : bands) {
    append_frequencies(modes, band.size, first);
    first += band.size / 2 + 1;
  }
  return std::make_unique<BandFourierBasis>(
      std::move(bands), concatenated(system.band_eigenvalues()), std::move(modes));
}

std::unique_ptr<ModalBasis> coefficient_basis(const LagrangeSystem& system) {
  std::vector<int> modes;
  int index = 0;
  for (const Band& band : multiscale_bands(system.samples(), system.levels())) {
    modes.insert(modes.end(), static_cast<std::size_t>(band.size), index++);
  }
  return std::make_unique<CoefficientBasis>(system.band_diagonals(), std::move(modes));
}

}  // namespace wavecurve::dynamics
