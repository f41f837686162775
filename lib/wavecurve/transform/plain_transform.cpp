#include "wavecurve/transform/plain_transform.hpp"

#include "wavecurve/transform/bands.hpp"

namespace wavecurve::plain {

namespace {

Eigen::Index modulo(Eigen::Index n, Eigen::Index period) {
  const Eigen::Index remainder = n % period;
  return remainder < 0 ? remainder + period : remainder;
}

}  // namespace

template <class Scalar>
Vector<Scalar> periodized(const Filter<Scalar>& filter, Eigen::Index period) {
  Vector<Scalar> result = Vector<Scalar>::Zero(period);
  Eigen::Index n = modulo(filter.first_index, period);
  for (const Scalar tap : filter.taps) {
    result[n] += tap;
    if (++n == period) n = 0;
  }
  return result;
}

template <class Scalar>
Vector<Scalar> forward_transform(const FilterBank<Scalar>& bank, int levels,
                                 const ConstVectorRef<Scalar>& samples) {
  Vector<Scalar> result = samples;
  multiscale_bands(samples.size(), levels);
  Eigen::Index period = samples.size();
  for (int level = 0; level < levels; ++level, period /= 2) {
    const Vector<Scalar> h = periodized(bank.analysis_low, period);
    const Vector<Scalar> g = periodized(bank.analysis_high, period);
    const Vector<Scalar> c = result.head(period);
    result.head(period).setZero();
    for (Eigen::Index n = 0; n < period / 2; ++n) {
      for (Eigen::Index l = 0; l < period; ++l) {
        result[n] += h[modulo(l - 2 * n, period)] * c[l];
        result[period / 2 + n] += g[modulo(l - 2 * n, period)] * c[l];
      }
    }
  }
  return result;
}

template <class Scalar>
Vector<Scalar> inverse_transform(const FilterBank<Scalar>& bank, int levels,
                                 const ConstVectorRef<Scalar>& coefficients) {
  Vector<Scalar> result = coefficients;
  multiscale_bands(coefficients.size(), levels);
  Eigen::Index period = coefficients.size() >> levels;
  for (int level = 0; level < levels; ++level) {
    period *= 2;
    const Vector<Scalar> h = periodized(bank.synthesis_low, period);
    const Vector<Scalar> g = periodized(bank.synthesis_high, period);
    const Vector<Scalar> c = result.head(period / 2);
    const Vector<Scalar> d = result.segment(period / 2, period / 2);
    result.head(period).setZero();
    for (Eigen::Index n = 0; n < period; ++n) {
      for (Eigen::Index l = 0; l < period / 2; ++l) {
        result[n] += h[modulo(n - 2 * l, period)] * c[l] + g[modulo(n - 2 * l, period)] * d[l];
      }
    }
  }
  return result;
}

template Vector<double> periodized(const Filter<double>&, Eigen::Index);
template Vector<float> periodized(const Filter<float>&, Eigen::Index);
template Vector<double> forward_transform(const FilterBank<double>&, int,
                                          const ConstVectorRef<double>&);
template Vector<float> forward_transform(const FilterBank<float>&, int,
                                         const ConstVectorRef<float>&);
template Vector<double> inverse_transform(const FilterBank<double>&, int,
                                          const ConstVectorRef<double>&);
template Vector<float> inverse_transform(const FilterBank<float>&, int,
                                         const ConstVectorRef<float>&);

}  // namespace wavecurve::plain
