#include "wavecurve/dynamics/oscillator.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "wavecurve/dynamics/exponential_difference.hpp"

namespace wavecurve {

namespace {

using Complex = std::complex<double>;

void check(const Oscillator& oscillator, double t) {
  const auto demand = [](bool condition, const char* name, double value, const char* bound) {
    if (condition) return;
    throw std::invalid_argument(std::string("oscillator: ") + name + " is " +
                                std::to_string(value) + ", but must be finite and " + bound);
  };
  demand(oscillator.rho > 0 && std::isfinite(oscillator.rho), "rho", oscillator.rho, "above 0");
  demand(oscillator.c >= 0 && std::isfinite(oscillator.c), "c", oscillator.c, "at least 0");
  demand(oscillator.k >= 0 && std::isfinite(oscillator.k), "k", oscillator.k, "at least 0");
  demand(t >= 0 && std::isfinite(t), "t", t, "at least 0");
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
  const auto [slow, fast] = roots(oscillator);
  // The response to an impulse, t exp[slow t, fast t]; of real roots, or of a conjugate pair, it is
  // real, and so are the others.
  const Complex impulse = t * exponential_difference(slow * t, fast * t);
  Propagator p;
  p.qq = (std::exp(slow * t) - slow * impulse).real();
  p.qv = impulse.real();
  p.vq = -(slow * fast * impulse).real();
  p.vv = (std::exp(fast * t) + slow * impulse).real();
  p.qf = (t * t * exponential_difference(slow * t, fast * t, 0)).real() / oscillator.rho;
  p.vf = p.qv / oscillator.rho;
  return p;
}

HarmonicResponse harmonic_response(const Oscillator& oscillator, double omega, double t) {
  check(oscillator, t);
  const auto [slow, fast] = roots(oscillator);
  const Complex force = {0, omega};
  const Complex q = t * t * exponential_difference(slow * t, fast * t, force * t) / oscillator.rho;
  // q' + (-slow) q is the response of the first-order factor alone, t exp[fast t, i omega t].
  const Complex v = slow * q + t * exponential_difference(fast * t, force * t) / oscillator.rho;
  return {q, v};
}

}  // namespace wavecurve
