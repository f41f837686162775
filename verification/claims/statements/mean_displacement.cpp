// The hoop of Figure 6 is said to return to its natural shape completely, without external force
// and friction. A constant displacement costs no energy and meets no elastic force, so its mean
// stays.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/core.h>

#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "verification/study/free_motion.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::mean_displacement_claim {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int samples = 64;
constexpr double mean = 0.25;

struct Displacement {
  std::string name;
  VectorXd values;
};

/// Displacements of one coordinate along the hoop; the largest of the first is 1.
std::vector<Displacement> displacements() {
  VectorXd ellipse(samples), dented(samples);
  for (int i = 0; i < samples; ++i) {
    const double angle = 2 * std::numbers::pi * i / samples;
    ellipse(i) = cosine(angle);
    dented(i) = cosine(angle) + 0.4 * cosine(2 * angle) + 0.2 * sine(5 * angle);
  }
  const VectorXd shift = VectorXd::Constant(samples, mean);
  return {{"stretched to an ellipse", ellipse},
          {"the ellipse, moved by 0.25", ellipse + shift},
          {"dented", dented},
          {"dented, moved by 0.25", dented + shift}};
}

/// What is left of a displacement, as its largest value; with and without its mean.
struct Remainder {
  double place, shape;
};

Remainder remainder(const VectorXd& displacement) {
  const VectorXd shape = displacement.array() - displacement.mean();
  return {displacement.cwiseAbs().maxCoeff(), shape.cwiseAbs().maxCoeff()};
}

/// The smallest remainders at any of the instants, each by itself.
Remainder least_remainder(const MatrixXd& motion) {
  Remainder least = remainder(motion.col(0));
  for (Eigen::Index i = 1; i < motion.cols(); ++i) {
    const Remainder now = remainder(motion.col(i));
    least.place = std::min(least.place, now.place);
    least.shape = std::min(least.shape, now.shape);
  }
  return least;
}

/// Four decimals; a mean that is zero but for rounding must not show the sign of its rounding
/// error.
std::string number(double value) {
  return fmt::format("{:.4f}", std::round(value * 1e4) / 1e4 + 0.0);
}

Outcome evaluate() {
  const MatrixXd stiffness = wavecurve::stiffness(find_filter_bank("db4"), samples, 0);
  const dynamics::Material undamped{}, damped{.mass_damping = 4 * std::numbers::pi};
  const VectorXd one_period = VectorXd::LinSpaced(4001, 0, 1);
  const VectorXd late = VectorXd::Constant(1, 10);
  Table table{
      "Largest displacement that is left after release; D8, N = 64, ρ = 1, e_0 = 1",
      {"displacement", "mean", "at release", "undamped, least over one period",
       "the same without the mean", "damped, at τ = 10", "the same without the mean, damped"},
      {}};
  double zero_mean_left = 0, moved_left = 0;
  for (const auto& [name, start] : displacements()) {
    const Remainder free = least_remainder(free_motion(stiffness, undamped, start, one_period));
    const Remainder rest = remainder(free_motion(stiffness, damped, start, late).col(0));
    const bool is_moved = start.mean() > mean / 2;
    double& left = is_moved ? moved_left : zero_mean_left;
    left = std::max(left, rest.place);
    table.rows.push_back({name, number(start.mean()), number(start.cwiseAbs().maxCoeff()),
                          number(free.place), number(free.shape), number(rest.place),
                          number(rest.shape)});
  }
  const double force =
      (stiffness * VectorXd::Ones(samples)).cwiseAbs().maxCoeff() / stiffness.cwiseAbs().maxCoeff();
  const bool is_as_expected = zero_mean_left < 1e-4 && moved_left > mean / 2;
  return {
      is_as_expected ? ClaimVerdict::depends_on_definition : ClaimVerdict::undecided,
      {"complete for a displacement of mean zero; of one with mean {} there remains {}",
       {to_decimals("mean of the displacement", mean, 2),
        to_decimals("displacement that remains of one with this mean", moved_left, 4),
        to_decimals("displacement that remains of one with mean zero", zero_mean_left, 4)}},
      "As a shape, wherever it lies, the hoop can be restored; as a curve in its place only if the "
      "displacement has mean zero, since constants are in the null space of K.",
      {Paragraph{fmt::format(
           "The elastic force of a constant displacement is {:.0e} of the largest entry "
           "of K, which is rounding: the mean of a hoop released at rest never moves.",
           force)},
       table,
       Paragraph{
           "Without friction, as printed, the motion never stops. A single mode passes through the "
           "natural shape once every half period; several modes together need not pass through it "
           "at "
           "all. It takes friction for the hoop to come to rest there."}}};
}

const RegisterClaim registered({"mean-displacement",
                                "The deformed hoop returns to its natural shape completely",
                                "Section 4.2, Figure 6",
                                "we assume the external force Q_e and the frictional force are "
                                "zero so the deformed hoop can be "
                                "restored to its natural shape completely",
                                evaluate});

}  // namespace

}  // namespace wavecurve::verification::mean_displacement_claim
