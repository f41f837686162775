#include "wavecurve/transform/detail/stockham_transform.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "wavecurve/elementary/detail/highway_targets.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/detail/stockham_transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// Real and imaginary parts.
template <class T>
struct Parts {
  T* re;
  T* im;
};

template <class V>
HWY_INLINE void transform_four(V* re, V* im) {
  const V even_re = hn::Add(re[0], re[2]), even_im = hn::Add(im[0], im[2]);
  const V odd_re = hn::Add(re[1], re[3]), odd_im = hn::Add(im[1], im[3]);
  const V a_re = hn::Sub(re[0], re[2]), a_im = hn::Sub(im[0], im[2]);
  const V b_re = hn::Sub(re[1], re[3]), b_im = hn::Sub(im[1], im[3]);
  re[0] = hn::Add(even_re, odd_re), im[0] = hn::Add(even_im, odd_im);
  re[1] = hn::Add(a_re, b_im), im[1] = hn::Sub(a_im, b_re);  // a - i b
  re[2] = hn::Sub(even_re, odd_re), im[2] = hn::Sub(even_im, odd_im);
  re[3] = hn::Sub(a_re, b_im), im[3] = hn::Add(a_im, b_re);
}

template <class V>
HWY_INLINE void multiply(V& re, V& im, V factor_re, V factor_im) {
  const V product = hn::Sub(hn::Mul(re, factor_re), hn::Mul(im, factor_im));
  im = hn::Add(hn::Mul(re, factor_im), hn::Mul(im, factor_re));
  re = product;
}

/// Vectors along the numbers of the source, n / 4 of which must be whole vectors.
template <class D>
HWY_INLINE void first_step(D d, Index n, const double* roots, const double* source, bool inverse,
                           Parts<double> to) {
  const Index quarter = n / 4;
  for (Index p = 0; p < quarter; p += static_cast<Index>(hn::Lanes(d))) {
    hn::Vec<D> re[4], im[4];
    for (Index j = 0; j < 4; ++j) {
      hn::LoadInterleaved2(d, source + 2 * (p + j * quarter), re[j], im[j]);
      if (inverse) std::swap(re[j], im[j]);
    }
    transform_four(re, im);
    for (Index j = 1; j < 4; ++j) {
      const double* root = roots + (2 * j - 2) * quarter + p;
      multiply(re[j], im[j], hn::LoadU(d, root), hn::LoadU(d, root + quarter));
    }
    hn::StoreInterleaved4(re[0], re[1], re[2], re[3], d, to.re + 4 * p);
    hn::StoreInterleaved4(im[0], im[1], im[2], im[3], d, to.im + 4 * p);
  }
}

/// One pass of `stride` transforms of length n / stride, side by side, which are whole vectors.
template <class D>
HWY_INLINE void step(D d, Index n, Index stride, const double* roots, Parts<const double> from,
                     Parts<double> to) {
  const Index quarter = n / 4;
  for (Index p = 0; p < quarter; p += stride) {
    hn::Vec<D> root_re[4], root_im[4];
    for (Index j = 1; j < 4; ++j) {
      root_re[j] = hn::Set(d, roots[(2 * j - 2) * quarter + p]);
      root_im[j] = hn::Set(d, roots[(2 * j - 1) * quarter + p]);
    }
    for (Index q = 0; q < stride; q += static_cast<Index>(hn::Lanes(d))) {
      hn::Vec<D> re[4], im[4];
      for (Index j = 0; j < 4; ++j) {
        re[j] = hn::LoadU(d, from.re + p + q + j * quarter);
        im[j] = hn::LoadU(d, from.im + p + q + j * quarter);
      }
      transform_four(re, im);
      for (Index j = 1; j < 4; ++j) multiply(re[j], im[j], root_re[j], root_im[j]);
      for (Index j = 0; j < 4; ++j) {
        hn::StoreU(re[j], d, to.re + 4 * p + q + j * stride);
        hn::StoreU(im[j], d, to.im + 4 * p + q + j * stride);
      }
    }
  }
}

/// Transforms of length two, n / 2 of them.
template <class D>
HWY_INLINE void last_step(D d, Index n, const double* from, double* to) {
  for (Index q = 0; q < n / 2; q += static_cast<Index>(hn::Lanes(d))) {
    const auto a = hn::LoadU(d, from + q), b = hn::LoadU(d, from + q + n / 2);
    hn::StoreU(hn::Add(a, b), d, to + q);
    hn::StoreU(hn::Sub(a, b), d, to + q + n / 2);
  }
}

/// n >= 4; the workspace is 4 n.
void stockham(Index n, const double* roots, const double* source, bool inverse, double scale,
              double* workspace, double* target) {
  const hn::CappedTag<double, 8> wide;
  const hn::CappedTag<double, 4> narrow;
  const hn::CappedTag<double, 1> single;
  Parts<double> x{workspace, workspace + n}, y{workspace + 2 * n, workspace + 3 * n};
  if (n >= 32) first_step(wide, n, roots, source, inverse, x);
  if (n < 32) first_step(single, n, roots, source, inverse, x);
  Index stride = 4;
  for (; 4 * stride <= n; stride *= 4) {
    const Parts<const double> from{x.re, x.im};
    if (stride == 4) step(narrow, n, stride, roots, from, y);
    if (stride > 4) step(wide, n, stride, roots, from, y);
    std::swap(x, y);
  }
  if (stride < n) {
    last_step(narrow, n, x.re, y.re);
    last_step(narrow, n, x.im, y.im);
    std::swap(x, y);
  }
  if (inverse) std::swap(x.re, x.im);
  const auto factor = hn::Set(narrow, scale);
  for (Index k = 0; k < n; k += static_cast<Index>(hn::Lanes(narrow))) {
    hn::StoreInterleaved2(hn::Mul(factor, hn::LoadU(narrow, x.re + k)),
                          hn::Mul(factor, hn::LoadU(narrow, x.im + k)), narrow, target + 2 * k);
  }
}

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

HWY_EXPORT(stockham);

namespace {

Eigen::Index checked(Eigen::Index size) {
  if (is_power_of_two(size)) return size;
  throw std::invalid_argument(must_be("size", size, "a power of two"));
}

}  // namespace

StockhamTransform::StockhamTransform(Eigen::Index size)
    : size_(checked(size)), roots_(size / 4, 6), workspace_(4 * size) {
  const Eigen::Index quarter = size / 4;
  // Sines and cosines of the first eighth; the others are these, by symmetry.
  for (Eigen::Index k = 0; 2 * k <= quarter; ++k) {
    if (quarter == 0) break;
    const double angle = 2 * std::numbers::pi / static_cast<double>(size) * static_cast<double>(k);
    const auto [sine, cosine] = sine_cosine(angle);
    roots_.row(k).head<2>() << cosine, -sine;
    if (k > 0) roots_.row(quarter - k).head<2>() << sine, -cosine;
  }
  for (Eigen::Index j = 2; j < 4; ++j) {
    for (Eigen::Index k = 0; k < quarter; ++k) {
      // A quarter of the circle is a factor -i.
      Complex root(roots_(j * k % quarter, 0), roots_(j * k % quarter, 1));
      for (Eigen::Index turn = 0; turn < j * k / quarter; ++turn)
        root = {root.imag(), -root.real()};
      roots_.row(k).segment<2>(2 * j - 2) << root.real(), root.imag();
    }
  }
}

void StockhamTransform::transform(const Complex* source, Complex* target, bool inverse,
                                  double scale) {
  if (size_ < 4) {
    const Complex a = source[0], b = source[size_ - 1];
    target[0] = scale * (size_ == 1 ? a : a + b);
    if (size_ == 2) target[1] = scale * (a - b);
    return;
  }
  HWY_DYNAMIC_DISPATCH(stockham)
  (size_, roots_.data(), reinterpret_cast<const double*>(source), inverse, scale, workspace_.data(),
   reinterpret_cast<double*>(target));
}

}  // namespace wavecurve
#endif
