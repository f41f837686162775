#include "wavecurve/transform/fourier_transform.hpp"

#include <algorithm>
#include <bit>
#include <complex>
#include <cstdint>
#include <numbers>
#include <optional>

#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/transform/detail/stockham_transform.hpp"

namespace wavecurve {

namespace {

using Complex = std::complex<double>;

constexpr Eigen::Index longest_direct = 1 << 14;

/// Without the check for infinities and NaNs that std::complex pays for.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Complex on_circle(double angle) {
  const auto [sine, cosine] = sine_cosine(angle);
  return {cosine, sine};
}

/// Columns handled at a time: two cache lines of each row that they cross.
constexpr Eigen::Index strip = 8;

}  // namespace

class FourierTransform::Steps {
 public:
  explicit Steps(Eigen::Index size);

  void transform(Complex* x, bool inverse);

 private:
  void make_chirp();
  void by_chirp(Complex* x, bool inverse);
  void in_four_steps(Complex* x, bool inverse);

  Eigen::Index size_, rows_ = 1;  ///< rows_ = 2^shift_ > 1: in four steps
  Eigen::Index pitch_ = 0;
  int shift_ = 0;
  std::optional<StockhamTransform> of_columns_, of_rows_;  ///< lengths size / rows_ and rows_
  Vector buffer_, gathered_, coarse_, fine_;
  std::unique_ptr<Steps> longer_;  ///< of a length that is no power of two
  Vector chirp_, chirp_spectrum_;
};

FourierTransform::Steps::Steps(Eigen::Index size) : size_(size) {
  if (!is_power_of_two(size)) {
    make_chirp();
    return;
  }
  if (size > longest_direct) buffer_.resize(size);
  while (size > longest_direct && rows_ * rows_ < size) {
    rows_ *= 2;
    ++shift_;
  }
  of_columns_.emplace(size / rows_);
  if (rows_ == 1) return;
  of_rows_.emplace(rows_);
  pitch_ =
      rows_ + 4;  // a cache line more, lest the columns of a strip share their place in the cache
  gathered_.resize(strip * pitch_);
  // e^(-2 pi i m / n) for m = a rows_ + b as a product of two of a table.
  coarse_.resize(size / rows_);
  fine_.resize(rows_);
  const double angle = -2 * std::numbers::pi / static_cast<double>(size);
  for (Eigen::Index a = 0; a < coarse_.size(); ++a) {
    coarse_[a] = on_circle(angle * static_cast<double>(a * rows_));
  }
  for (Eigen::Index b = 0; b < rows_; ++b) fine_[b] = on_circle(angle * static_cast<double>(b));
}

void FourierTransform::Steps::transform(Complex* x, bool inverse) {
  if (!of_columns_) return by_chirp(x, inverse);
  if (of_rows_) return in_four_steps(x, inverse);
  of_columns_->transform(x, x, inverse, inverse ? 1.0 / static_cast<double>(size_) : 1);
}

void FourierTransform::Steps::make_chirp() {
  Eigen::Index length = 1;
  while (length < 2 * size_ - 1) length *= 2;
  longer_ = std::make_unique<Steps>(length);
  buffer_.resize(length);
  chirp_.resize(size_);
  chirp_spectrum_ = Vector::Zero(length);
  const double angle = -std::numbers::pi / static_cast<double>(size_);
  Eigen::Index square = 0;  // of j, modulo 2 n: the angles stay small, and their products exact
  for (Eigen::Index j = 0; j < size_; ++j) {
    chirp_[j] = on_circle(angle * static_cast<double>(square));
    chirp_spectrum_[j] = chirp_spectrum_[(length - j) % length] = std::conj(chirp_[j]);
    square = (square + 2 * j + 1) % (2 * size_);
  }
  longer_->transform(chirp_spectrum_.data(), false);
}

void FourierTransform::Steps::by_chirp(Complex* x, bool inverse) {
  // With w_j = e^(-pi i j^2 / n), j k = (j^2 + k^2 - (k - j)^2) / 2 makes the sum a convolution,
  //   X_k = w_k sum_j (x_j w_j) conj(w_{k-j})   (Bluestein 1970);
  // the inverse is the conjugate of the transform of the conjugate, divided by n.
  const auto given = [&](Complex value) { return inverse ? std::conj(value) : value; };
  for (Eigen::Index j = 0; j < size_; ++j) buffer_[j] = product(given(x[j]), chirp_[j]);
  buffer_.tail(buffer_.size() - size_).setZero();
  longer_->transform(buffer_.data(), false);
  for (Eigen::Index k = 0; k < buffer_.size(); ++k) {
    buffer_[k] = product(buffer_[k], chirp_spectrum_[k]);
  }
  longer_->transform(buffer_.data(), true);
  const double scale = inverse ? 1.0 / static_cast<double>(size_) : 1;
  for (Eigen::Index k = 0; k < size_; ++k) {
    x[k] = scale * given(product(buffer_[k], chirp_[k]));
  }
}

void FourierTransform::Steps::in_four_steps(Complex* x, bool inverse) {
  // With j = r + rows j', k = k' + others k'':
  //   X_k = sum_r w_rows^(r k'') w_size^(r k') sum_j' w_others^(j' k') x_j.
  const Eigen::Index others = size_ / rows_;
  const auto rows = static_cast<std::uint64_t>(rows_);
  const double scale = inverse ? 1.0 / static_cast<double>(size_) : 1;
  for (Eigen::Index first = 0; first < rows_; first += strip) {
    for (Eigen::Index j = 0; j < others; ++j) {
      for (Eigen::Index r = 0; r < strip; ++r) gathered_[r * pitch_ + j] = x[j * rows_ + first + r];
    }
    for (Eigen::Index r = 0; r < strip; ++r) {
      Complex* column = &gathered_[r * pitch_];
      of_columns_->transform(column, column, inverse, 1);
      for (Eigen::Index k = 0; k < others; ++k) {
        const auto m = static_cast<std::uint64_t>((first + r) * k);
        const Complex w = product(coarse_.data()[m >> shift_], fine_.data()[m & (rows - 1)]);
        column[k] = product(column[k], inverse ? std::conj(w) : w);
      }
    }
    for (Eigen::Index k = 0; k < others; ++k) {
      for (Eigen::Index r = 0; r < strip; ++r) {
        buffer_[k * rows_ + first + r] = gathered_[r * pitch_ + k];
      }
    }
  }
  for (Eigen::Index first = 0; first < others; first += strip) {
    for (Eigen::Index k = 0; k < strip; ++k) {
      of_rows_->transform(&buffer_[(first + k) * rows_], &gathered_[k * pitch_], inverse, scale);
    }
    for (Eigen::Index r = 0; r < rows_; ++r) {
      for (Eigen::Index k = 0; k < strip; ++k) {
        x[r * others + first + k] = gathered_[k * pitch_ + r];
      }
    }
  }
}

FourierTransform::FourierTransform(Eigen::Index size) : steps_(std::make_unique<Steps>(size)) {}
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;
FourierTransform::~FourierTransform() = default;

void FourierTransform::forward(Eigen::Ref<Vector> x) { steps_->transform(x.data(), false); }

void FourierTransform::inverse(Eigen::Ref<Vector> x) { steps_->transform(x.data(), true); }

}  // namespace wavecurve
