#include "wavecurve/dynamics/fourier_transform.hpp"

#include <algorithm>
#include <cstdint>
#include <numbers>

namespace wavecurve {

namespace {

using Complex = std::complex<double>;

constexpr Eigen::Index longest_direct = 1 << 14;

/// Without the check for infinities and NaNs that std::complex pays for.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Columns handled at a time: two cache lines of each row that they cross.
constexpr Eigen::Index strip = 8;

}  // namespace

FourierTransform::FourierTransform(Eigen::Index size) : size_(size), buffer_(size) {
  fft_.SetFlag(Eigen::FFT<double>::Unscaled);
  if (size <= longest_direct) return;
  while (rows_ * rows_ < size) {
    rows_ *= 2;
    ++shift_;
  }
  pitch_ =
      rows_ + 4;  // a cache line more, lest the columns of a strip share their place in the cache
  gathered_.resize(strip * pitch_);
  transformed_.resize(strip * pitch_);
  // e^(-2 pi i m / n) for m = a rows_ + b as a product of two of a table.
  coarse_.resize(size / rows_);
  fine_.resize(rows_);
  const double angle = -2 * std::numbers::pi / static_cast<double>(size);
  for (Eigen::Index a = 0; a < coarse_.size(); ++a) {
    coarse_[a] = std::polar(1.0, angle * static_cast<double>(a * rows_));
  }
  for (Eigen::Index b = 0; b < rows_; ++b)
    fine_[b] = std::polar(1.0, angle * static_cast<double>(b));
}

void FourierTransform::direct(const Complex* source, Complex* target, Eigen::Index length,
                              bool inverse) {
  if (inverse) fft_.inv(target, source, static_cast<int>(length));
  if (!inverse) fft_.fwd(target, source, static_cast<int>(length));
}

void FourierTransform::transform(Complex* x, bool inverse) {
  if (size_ == 1) return;  // Eigen's cannot do that
  if (rows_ > 1) return in_four_steps(x, inverse);
  direct(x, buffer_.data(), size_, inverse);
  const double scale = inverse ? 1.0 / static_cast<double>(size_) : 1;
  std::transform(buffer_.data(), buffer_.data() + size_, x,
                 [scale](const Complex& value) { return scale * value; });
}

void FourierTransform::in_four_steps(Complex* x, bool inverse) {
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
      direct(&gathered_[r * pitch_], &transformed_[r * pitch_], others, inverse);
      for (Eigen::Index k = 0; k < others; ++k) {
        const auto m = static_cast<std::uint64_t>((first + r) * k);
        const Complex w = product(coarse_.data()[m >> shift_], fine_.data()[m & (rows - 1)]);
        Complex& value = transformed_[r * pitch_ + k];
        value = product(value, inverse ? std::conj(w) : w);
      }
    }
    for (Eigen::Index k = 0; k < others; ++k) {
      for (Eigen::Index r = 0; r < strip; ++r) {
        buffer_[k * rows_ + first + r] = transformed_[r * pitch_ + k];
      }
    }
  }
  for (Eigen::Index first = 0; first < others; first += strip) {
    for (Eigen::Index k = 0; k < strip; ++k) {
      direct(&buffer_[(first + k) * rows_], &transformed_[k * pitch_], rows_, inverse);
    }
    for (Eigen::Index r = 0; r < rows_; ++r) {
      for (Eigen::Index k = 0; k < strip; ++k) {
        x[r * others + first + k] = scale * transformed_[k * pitch_ + r];
      }
    }
  }
}

void FourierTransform::forward(Eigen::Ref<Vector> x) { transform(x.data(), false); }

void FourierTransform::inverse(Eigen::Ref<Vector> x) { transform(x.data(), true); }

}  // namespace wavecurve
