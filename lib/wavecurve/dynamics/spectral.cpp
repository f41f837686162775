#include "wavecurve/dynamics/spectral.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <unsupported/Eigen/FFT>
#include <utility>
#include <vector>

#include "wavecurve/dynamics/oscillator.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

namespace {

using Complex = std::complex<double>;
using Spectrum = Eigen::MatrixXcd;  ///< one column a coordinate, or a pair of them

/// Between coefficients in the multiscale basis and Fourier coefficients of the finest level. Two
/// coordinates are one complex number: every symbol is real and even, so they stay apart.
class SpectralBasis {
 public:
  explicit SpectralBasis(const LagrangeSystem& system)
      : transform_(system.bank(), system.samples(), system.levels()),
        workspace_(transform_.workspace_size()),
        fine_(system.samples()),
        pair_(system.samples()),
        transformed_(system.samples()) {}

  Spectrum forward(const Eigen::MatrixXd& coefficients) {
    Spectrum spectrum(coefficients.rows(), (coefficients.cols() + 1) / 2);
    for (Eigen::Index j = 0; j < spectrum.cols(); ++j) {
      pair_.setZero();
      for (Eigen::Index part = 0; part < 2 && 2 * j + part < coefficients.cols(); ++part) {
        transform_.inverse(coefficients.col(2 * j + part), fine_, workspace_);
        if (part == 0) pair_.real() = fine_;
        if (part == 1) pair_.imag() = fine_;
      }
      transformed_ = pair_;
      if (pair_.size() > 1) fft_.fwd(transformed_, pair_);  // Eigen's cannot do length 1
      spectrum.col(j) = transformed_;
    }
    return spectrum;
  }

  Eigen::MatrixXd backward(const Spectrum& spectrum, Eigen::Index coordinates) {
    Eigen::MatrixXd coefficients(spectrum.rows(), coordinates);
    for (Eigen::Index j = 0; j < spectrum.cols(); ++j) {
      transformed_ = spectrum.col(j);
      pair_ = transformed_;
      if (pair_.size() > 1) fft_.inv(pair_, transformed_);
      for (Eigen::Index part = 0; part < 2 && 2 * j + part < coordinates; ++part) {
        if (part == 0) fine_ = pair_.real();
        if (part == 1) fine_ = pair_.imag();
        transform_.forward(fine_, coefficients.col(2 * j + part), workspace_);
      }
    }
    return coefficients;
  }

 private:
  PeriodicTransform<double> transform_;
  Eigen::VectorXd workspace_, fine_;
  Eigen::VectorXcd pair_, transformed_;
  Eigen::FFT<double> fft_;
};

/// One propagator a frequency, n = 0 .. samples / 2.
using Propagators = std::vector<Propagator>;

std::vector<Oscillator> oscillators(const Symbols& symbols) {
  std::vector<Oscillator> result;
  for (Eigen::Index n = 0; n < symbols.mass.size(); ++n) {
    result.push_back({symbols.mass[n], symbols.damping[n], symbols.stiffness[n]});
  }
  return result;
}

Propagators propagators(const std::vector<Oscillator>& modes, double t) {
  Propagators result;
  for (const Oscillator& mode : modes) result.push_back(propagator(mode, t));
  return result;
}

/// First a, then b: the solution after the sum of their times.
Propagator compose(const Propagator& a, const Propagator& b) {
  return {b.qq * a.qq + b.qv * a.vq,        b.qq * a.qv + b.qv * a.vv,
          b.vq * a.qq + b.vv * a.vq,        b.vq * a.qv + b.vv * a.vv,
          b.qq * a.qf + b.qv * a.vf + b.qf, b.vq * a.qf + b.vv * a.vf + b.vf};
}

/// The propagators of all times, each composed of two tabulated ones if the times are j dt: for T
/// times 2 sqrt T exponentials a frequency instead of T.
class Timetable {
 public:
  Timetable(std::vector<Oscillator> modes, const Eigen::VectorXd& times)
      : modes_(std::move(modes)), times_(times) {
    const Eigen::Index count = times.size();
    if (count < 4) return;
    const double step = times[count - 1] / static_cast<double>(count - 1);
    for (Eigen::Index j = 0; j < count; ++j) {
      // Equal but for the rounding of a product and of a division.
      const double time = static_cast<double>(j) * step;
      if (std::abs(times[j] - time) > 4 * std::numeric_limits<double>::epsilon() * time) return;
    }
    while (block_ * block_ < count) ++block_;
    for (Eigen::Index j = 0; j < block_; ++j) {
      small_.push_back(propagators(modes_, static_cast<double>(j) * step));
      large_.push_back(propagators(modes_, static_cast<double>(j * block_) * step));
    }
  }

  Propagators at(Eigen::Index j) const {
    if (small_.empty()) return propagators(modes_, times_[j]);
    Propagators result = large_[static_cast<std::size_t>(j / block_)];
    const Propagators& rest = small_[static_cast<std::size_t>(j % block_)];
    for (std::size_t n = 0; n < result.size(); ++n) result[n] = compose(result[n], rest[n]);
    return result;
  }

 private:
  std::vector<Oscillator> modes_;
  Eigen::VectorXd times_;
  Eigen::Index block_ = 1;
  std::vector<Propagators> small_, large_;
};

struct SpectralState {
  Spectrum displacement, velocity;
};

/// The frequency n of row k: both k and rows - k have it.
std::size_t frequency(Eigen::Index k, Eigen::Index rows) {
  return static_cast<std::size_t>(std::min(k, rows - k));
}

SpectralState advance(const SpectralState& start, const Spectrum& force,
                      const Propagators& propagators) {
  const Eigen::Index rows = start.displacement.rows();
  SpectralState state = {Spectrum(rows, start.displacement.cols()),
                         Spectrum(rows, start.displacement.cols())};
  for (Eigen::Index j = 0; j < start.displacement.cols(); ++j) {
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Propagator& p = propagators[frequency(k, rows)];
      const Complex q = start.displacement(k, j), v = start.velocity(k, j), f = force(k, j);
      state.displacement(k, j) = p.qq * q + p.qv * v + p.qf * f;
      state.velocity(k, j) = p.vq * q + p.vv * v + p.vf * f;
    }
  }
  return state;
}

/// Densities as Fourier coefficients of the finest level's Q.
Spectrum force_spectrum(SpectralBasis& basis, const Symbols& symbols,
                        const Eigen::MatrixXd& density) {
  Spectrum spectrum = basis.forward(density);
  for (Eigen::Index k = 0; k < spectrum.rows(); ++k) {
    spectrum.row(k) *= symbols.gram[std::min(k, spectrum.rows() - k)];
  }
  return spectrum;
}

void add_harmonic(SpectralState& state, const Spectrum& cosine, const Spectrum& sine, double omega,
                  const std::vector<Oscillator>& modes, double t) {
  std::vector<HarmonicResponse> responses;
  for (const Oscillator& mode : modes) responses.push_back(harmonic_response(mode, omega, t));
  for (Eigen::Index j = 0; j < cosine.cols(); ++j) {
    for (Eigen::Index k = 0; k < cosine.rows(); ++k) {
      const HarmonicResponse& r = responses[frequency(k, cosine.rows())];
      state.displacement(k, j) += r.q.real() * cosine(k, j) + r.q.imag() * sine(k, j);
      state.velocity(k, j) += r.v.real() * cosine(k, j) + r.v.imag() * sine(k, j);
    }
  }
}

void check_solvable(const InitialValueProblem& problem) {
  check(problem);
  if (problem.system.material().density == 0) {
    throw std::domain_error(
        "density is 0, but must be above 0 here; the massless equation has solvers of its own");
  }
  if (!problem.force.general.empty()) {
    throw std::domain_error("a general force has no closed form: only constant and harmonic do");
  }
}

}  // namespace

Trajectory solve_spectral(const InitialValueProblem& problem) {
  check_solvable(problem);
  const Eigen::Index coordinates = problem.displacement.cols();
  SpectralBasis basis(problem.system);
  const Symbols symbols = problem.system.symbols();
  const std::vector<Oscillator> modes = oscillators(symbols);

  const Spectrum displacement = basis.forward(problem.displacement);
  const Spectrum zero = Spectrum::Zero(displacement.rows(), displacement.cols());
  const SpectralState start = {
      displacement, problem.velocity.size() > 0 ? basis.forward(problem.velocity) : zero};
  const Spectrum constant = problem.force.constant.size() > 0
                                ? force_spectrum(basis, symbols, problem.force.constant)
                                : zero;

  const Timetable timetable(modes, problem.times);
  Trajectory trajectory;
  for (Eigen::Index i = 0; i < problem.times.size(); ++i) {
    SpectralState state = advance(start, constant, timetable.at(i));
    for (const HarmonicForce& force : problem.force.harmonic) {
      add_harmonic(state, force_spectrum(basis, symbols, force.cosine),
                   force_spectrum(basis, symbols, force.sine), force.omega, modes,
                   problem.times[i]);
    }
    trajectory.displacement.push_back(basis.backward(state.displacement, coordinates));
    trajectory.velocity.push_back(basis.backward(state.velocity, coordinates));
  }
  return trajectory;
}

}  // namespace wavecurve
