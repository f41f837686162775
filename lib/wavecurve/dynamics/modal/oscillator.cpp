#include "wavecurve/dynamics/modal/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "wavecurve/dynamics/modal/detail/exponential_difference.hpp"
#include "wavecurve/elementary/exponential.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::dynamics {

namespace {

using Complex = std::complex<double>;

void check(const Oscillator& oscillator, double t) {
  check_at_least("rho of an oscillator", oscillator.rho, 0);
  check_at_least("c of an oscillator", oscillator.c, 0);
  check_at_least("k of an oscillator", oscillator.k, 0);
  check_at_least("t of an oscillator", t, 0);
  if (oscillator.rho == 0 && oscillator.c == 0) {
    throw std::invalid_argument(must_be("c of an oscillator", 0, "above 0 where rho is 0"));
  }
}

/// Without mass: c q' + k q = f.
Propagator relaxation(const Oscillator& oscillator, double t) {
  const double rate = -oscillator.k / oscillator.c;
  Propagator p;
  p.qq = exponential(rate * t);
  p.qv = p.vv = 0;
  p.vq = rate * p.qq;
  p.qf = t * phi_function(1, rate * t) / oscillator.c;
  p.vf = p.qq / oscillator.c;
  return p;
}

/// Below the critical damping, after more than about a radian: there nothing cancels in the
/// formulas as they stand. With exp(-decay t), and sine and cosine of omega t.
Propagator oscillation(const Oscillator& oscillator, double decay, double omega, double fading,
                       const SineCosine& turn) {
  Propagator p;
  p.qv = fading * turn.sine / omega;
  const double even = fading * turn.cosine;
  p.qq = even + decay * p.qv;
  p.vv = even - decay * p.qv;
  p.vq = -oscillator.k / oscillator.rho * p.qv;
  p.qf = (1 - p.qq) / oscillator.k;
  p.vf = p.qv / oscillator.rho;
  return p;
}

/// Divided differences exp[x, y, 0, ..., 0] with 0 .. 3 zeros, x and y real or conjugate, |x| <=
/// |y|.
std::array<double, 4> zero_differences(Complex x, Complex y) {
  const double sum = (x + y).real(), product = (x * y).real();
  std::array<double, 4> d = {};
  if (std::abs(y) <= 1) {
    // sum_n h_n / (n + m + 1)!, h_n the complete homogeneous polynomials, |h_n| <= n + 1.
    double h = 1, last = 0, factorial = 1;
    for (int n = 0; n <= 20; ++n) {
      factorial *= n + 1;
      double divisor = factorial;
      for (int m = 0; m < 4; ++m) {
        d[static_cast<std::size_t>(m)] += h / divisor;
        divisor *= n + m + 2;
      }
      const double next = sum * h - product * last;
      last = h;
      h = next;
    }
    return d;
  }
  if (y.imag() == 0 && std::abs(y) >= 2 * std::abs(x)) {
    for (int m = 0; m < 4; ++m) {
      d[static_cast<std::size_t>(m)] =
          (phi_function(m, x.real()) - phi_function(m, y.real())) / (x - y).real();
    }
    return d;
  }
  // d_m solves q'' - sum q' + product q = t^(m - 1) / (m - 1)! at time 1, its derivative is
  // d_{m-1}.
  d[0] = exponential_difference(x, y).real();
  const double before = (exponential(y) + x * exponential_difference(x, y)).real();
  d[1] = (1 + sum * d[0] - before) / product;
  d[2] = (1 + sum * d[1] - d[0]) / product;
  d[3] = (0.5 + sum * d[2] - d[1]) / product;
  return d;
}

}  // namespace

Roots roots(const Oscillator& oscillator) {
  const double decay = oscillator.c / (2 * oscillator.rho);
  const double frequency = std::sqrt(oscillator.k / oscillator.rho);
  // As a product, decay^2 - frequency^2 does not cancel beyond the difference of its factors.
  const double discriminant = (decay - frequency) * (decay + frequency);
  if (discriminant < 0) {
    const double omega = std::sqrt(-discriminant);
    return {{-decay, omega}, {-decay, -omega}};
  }
  const double fast = -(decay + std::sqrt(discriminant));
  // Vieta: the sum would cancel. Without damping and stiffness both roots are zero.
  return {fast == 0 ? 0 : frequency * frequency / fast, fast};
}

Propagator propagator(const Oscillator& oscillator, double t) {
  check(oscillator, t);
  if (oscillator.rho == 0) return relaxation(oscillator, t);
  if (t == 0) return {};
  const auto [slow, fast] = roots(oscillator);
  if (slow.imag() * t > 1) {
    return oscillation(oscillator, -slow.real(), slow.imag(), exponential(slow.real() * t),
                       sine_cosine(slow.imag() * t));
  }
  // The response to an impulse, t exp[slow t, fast t]; of real roots, or of a conjugate pair, it is
  // real, and so are the others.
  const Complex impulse = t * exponential_difference(slow * t, fast * t);
  Propagator p;
  p.qq = (exponential(slow * t) - slow * impulse).real();
  p.qv = impulse.real();
  p.vq = -(slow * fast * impulse).real();
  p.vv = (exponential(fast * t) + slow * impulse).real();
  p.qf = (t * t * exponential_difference(slow * t, fast * t, 0)).real() / oscillator.rho;
  p.vf = p.qv / oscillator.rho;
  return p;
}

void propagators(std::span<const Oscillator> oscillators, double t, std::span<Propagator> result) {
  constexpr std::size_t most = 128;  // at a time, so that all arrays stay in the cache
  std::array<double, most> decay, omega;
  Eigen::ArrayXd fading(most), sine(most), cosine(most);
  for (std::size_t first = 0; first < oscillators.size(); first += most) {
    const std::size_t count = std::min(most, oscillators.size() - first);
    const auto size = static_cast<Eigen::Index>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Oscillator& oscillator = oscillators[first + i];
      check(oscillator, t);
      const Roots r = oscillator.rho > 0 ? roots(oscillator) : Roots();
      decay[i] = -r.slow.real();
      omega[i] = r.slow.imag();
      fading[static_cast<Eigen::Index>(i)] = r.slow.real() * t;
      sine[static_cast<Eigen::Index>(i)] = omega[i] * t;
    }
    exponential(fading.head(size), fading.head(size));
    sine_cosine(sine.head(size), sine.head(size), cosine.head(size));
    for (std::size_t i = 0; i < count; ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      result[first + i] = omega[i] * t > 1 ? oscillation(oscillators[first + i], decay[i], omega[i],
                                                         fading[j], {sine[j], cosine[j]})
                                           : propagator(oscillators[first + i], t);
    }
  }
}

HarmonicResponse harmonic_response(const Oscillator& oscillator, double omega, double t) {
  check(oscillator, t);
  const Complex force = {0, omega};
  if (oscillator.rho == 0) {
    const double rate = -oscillator.k / oscillator.c;
    const Complex q = t * exponential_difference(rate * t, force * t) / oscillator.c;
    return {q, rate * q + exponential(force * t) / oscillator.c};
  }
  const auto [slow, fast] = roots(oscillator);
  const Complex q = t * t * exponential_difference(slow * t, fast * t, force * t) / oscillator.rho;
  // q' + (-slow) q is the response of the first-order factor alone, t exp[fast t, i omega t].
  const Complex v = slow * q + t * exponential_difference(fast * t, force * t) / oscillator.rho;
  return {q, v};
}

RampResponse ramp_response(const Oscillator& oscillator, double h) {
  check(oscillator, h);
  RampResponse response;
  if (oscillator.rho == 0) {
    const double rate = -oscillator.k / oscillator.c;
    for (int k = 0; k < 3; ++k) {
      response.q[static_cast<std::size_t>(k)] = h * phi_function(k + 1, rate * h) / oscillator.c;
    }
    return response;
  }
  const auto [slow, fast] = roots(oscillator);
  const std::array<double, 4> differences = zero_differences(slow * h, fast * h);
  for (std::size_t k = 0; k < 3; ++k) {
    response.q[k] = h * h * differences[k + 1] / oscillator.rho;
    response.v[k] = h * differences[k] / oscillator.rho;
  }
  return response;
}

}  // namespace wavecurve::dynamics
