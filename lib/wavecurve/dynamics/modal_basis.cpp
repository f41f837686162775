#include "wavecurve/dynamics/modal_basis.hpp"

#include <algorithm>
#include <utility>

#include "wavecurve/dynamics/fourier_transform.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

namespace {

long long fourier_operations(Eigen::Index size) {
  return 5 * static_cast<long long>(size) * checked_log2(size);
}

/// Rows k and size - k have the mode first + min(k, size - k).
void append_frequencies(std::vector<Eigen::Index>& modes, Eigen::Index size, Eigen::Index first) {
  for (Eigen::Index k = 0; k < size; ++k) modes.push_back(first + std::min(k, size - k));
}

class FourierBasis : public ModalBasis {
 public:
  FourierBasis(const LagrangeSystem& system, Symbols symbols, std::vector<Eigen::Index> modes)
      : ModalBasis(std::move(symbols), std::move(modes)),
        transform_(system.bank(), system.samples(), system.levels()),
        workspace_(transform_.workspace_size()),
        input_(system.samples()),
        output_(system.samples()),
        fourier_(system.samples()) {
    taps_ = system.bank().synthesis_low.size() + system.bank().synthesis_high.size();
  }

  long long operations() const override {
    // Each sample of each level has half of the taps of two filters, for two coordinates.
    return fourier_operations(rows()) + (rows() - (rows() >> transform_.levels())) * 4 * taps_;
  }

 private:
  void to_modes(Column values) override {
    input_ = values.real();
    transform_.inverse(input_, output_, workspace_);
    values.real() = output_;
    input_ = values.imag();
    transform_.inverse(input_, output_, workspace_);
    values.imag() = output_;
    fourier_.forward(values);
  }

  void from_modes(Column values) override {
    fourier_.inverse(values);
    input_ = values.real();
    transform_.forward(input_, output_, workspace_);
    values.real() = output_;
    input_ = values.imag();
    transform_.forward(input_, output_, workspace_);
    values.imag() = output_;
  }

  PeriodicTransform<double> transform_;
  Eigen::VectorXd workspace_, input_, output_;
  FourierTransform fourier_;
  long long taps_ = 0;
};

class BandFourierBasis : public ModalBasis {
 public:
  BandFourierBasis(std::vector<Band> bands, Symbols symbols, std::vector<Eigen::Index> modes)
      : ModalBasis(std::move(symbols), std::move(modes)), bands_(std::move(bands)) {
    for (const Band& band : bands_) fourier_.emplace_back(band.size);
  }

  long long operations() const override {
    long long sum = 0;
    for (const Band& band : bands_) sum += fourier_operations(band.size);
    return sum;
  }

 private:
  void to_modes(Column values) override {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      fourier_[i].forward(values.segment(bands_[i].offset, bands_[i].size));
    }
  }

  void from_modes(Column values) override {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      fourier_[i].inverse(values.segment(bands_[i].offset, bands_[i].size));
    }
  }

  std::vector<Band> bands_;
  std::vector<FourierTransform> fourier_;
};

class CoefficientBasis : public ModalBasis {
 public:
  CoefficientBasis(Symbols symbols, std::vector<Eigen::Index> modes)
      : ModalBasis(std::move(symbols), std::move(modes)) {}

  long long operations() const override { return 0; }

 private:
  void to_modes(Column) override {}
  void from_modes(Column) override {}
};

Symbols concatenated(const std::vector<Symbols>& parts) {
  const auto join = [&](Eigen::VectorXd Symbols::*member) {
    Eigen::Index size = 0;
    for (const Symbols& part : parts) size += (part.*member).size();
    Eigen::VectorXd result(size);
    Eigen::Index at = 0;
    for (const Symbols& part : parts) {
      result.segment(at, (part.*member).size()) = part.*member;
      at += (part.*member).size();
    }
    return result;
  };
  return {join(&Symbols::gram), join(&Symbols::mass), join(&Symbols::damping),
          join(&Symbols::stiffness)};
}

}  // namespace

ModalBasis::ModalBasis(Symbols modes, std::vector<Eigen::Index> mode_of_row)
    : modes_(std::move(modes)), mode_of_row_(std::move(mode_of_row)) {}

Spectrum ModalBasis::forward(const Eigen::Ref<const Eigen::MatrixXd>& coefficients) {
  Spectrum spectrum(coefficients.rows(), (coefficients.cols() + 1) / 2);
  for (Eigen::Index j = 0; j < spectrum.cols(); ++j) {
    spectrum.col(j).real() = coefficients.col(2 * j);
    if (2 * j + 1 < coefficients.cols()) spectrum.col(j).imag() = coefficients.col(2 * j + 1);
    if (2 * j + 1 == coefficients.cols()) spectrum.col(j).imag().setZero();
    to_modes(spectrum.col(j));
  }
  return spectrum;
}

Eigen::MatrixXd ModalBasis::backward(Spectrum spectrum, Eigen::Index coordinates) {
  Eigen::MatrixXd coefficients(spectrum.rows(), coordinates);
  for (Eigen::Index j = 0; j < spectrum.cols(); ++j) {
    from_modes(spectrum.col(j));
    coefficients.col(2 * j) = spectrum.col(j).real();
    if (2 * j + 1 < coordinates) coefficients.col(2 * j + 1) = spectrum.col(j).imag();
  }
  return coefficients;
}

std::unique_ptr<ModalBasis> fourier_basis(const LagrangeSystem& system) {
  std::vector<Eigen::Index> modes;
  append_frequencies(modes, system.samples(), 0);
  return std::make_unique<FourierBasis>(system, system.symbols(), std::move(modes));
}

std::unique_ptr<ModalBasis> band_fourier_basis(const LagrangeSystem& system) {
  std::vector<Band> bands = multiscale_bands(system.samples(), system.levels());
  std::vector<Eigen::Index> modes;
  Eigen::Index first = 0;
  for (const Band& band : bands) {
    append_frequencies(modes, band.size, first);
    first += band.size / 2 + 1;
  }
  return std::make_unique<BandFourierBasis>(std::move(bands), concatenated(system.band_symbols()),
                                            std::move(modes));
}

std::unique_ptr<ModalBasis> coefficient_basis(const LagrangeSystem& system) {
  std::vector<Eigen::Index> modes;
  Eigen::Index index = 0;
  for (const Band& band : multiscale_bands(system.samples(), system.levels())) {
    modes.insert(modes.end(), static_cast<std::size_t>(band.size), index++);
  }
  return std::make_unique<CoefficientBasis>(system.band_diagonals(), std::move(modes));
}

}  // namespace wavecurve
