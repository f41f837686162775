#pragma once

#include <array>
#include <complex>
#include <span>

namespace wavecurve::dynamics {

/// One degree of freedom, rho q'' + c q' + k q = f, all at least 0 and rho or c above 0.
/// Publication, (3.16), whose r_1, r_2 are the roots of rho r^2 + c r + k = 0 (the print has other
/// letters and dots). Without mass, rho = 0, the equation is of first order; its q' at time 0
/// follows from q.
struct Oscillator {
  double rho = 1, c = 0, k = 0;
};

/// The two roots, rho > 0, each to a few units of rounding also where they differ by orders of
/// magnitude or by little: complex conjugates, or real with slow >= fast.
struct Roots {
  std::complex<double> slow, fast;
};
Roots roots(const Oscillator& oscillator);

/// The solution at a time t as a linear function of the start and of a constant force:
///   q(t) = qq q(0) + qv q'(0) + qf f,   q'(t) = vq q(0) + vv q'(0) + vf f.
struct Propagator {
  double qq = 1, qv = 0, vq = 0, vv = 1, qf = 0, vf = 0;
};

/// In closed form, for any t >= 0 and any damping: below, at and above the critical one. The error
/// of qq, vv is a few units of rounding times 1 + |r| t (the argument of an oscillation is as exact
/// as its frequency), of qv and qf the same relative to t and t^2 / rho. Throws
/// std::invalid_argument naming what is negative or not finite, and for rho = c = 0.
Propagator propagator(const Oscillator& oscillator, double t);

/// The propagators of as many oscillators, each with the bits of the function above; sines, cosines
/// and exponentials are computed on vectors.
void propagators(std::span<const Oscillator> oscillators, double t, std::span<Propagator> result);

/// The response at time t, from rest, to the force e^(i omega t): q and q' as complex numbers, of
/// which the real part answers cos, the imaginary part sin. At resonance too.
struct HarmonicResponse {
  std::complex<double> q, v;
};
HarmonicResponse harmonic_response(const Oscillator& oscillator, double omega, double t);

/// What forces growing within a step h add to q and q' at its end: of the unit force, of s, and of
/// s^2 / 2, s = t / h from 0 to 1, in this order. For a massless oscillator only q is given, v is 0.
struct RampResponse {
  std::array<double, 3> q = {}, v = {};
};
RampResponse ramp_response(const Oscillator& oscillator, double h);

}  // namespace wavecurve::dynamics
