#include "verification/study/named_shapes.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::verification {
namespace {

constexpr Eigen::Index samples = 64;
constexpr double rounding = 1e-13;  // a few operations on numbers of order 1

TEST(NamedShapes, AreTheOnesThatOthersUse) {
  const Contour ellipse = named_shape("ellipse", samples), star = named_shape("star", samples);
  const Contour dent = named_shape("dent", samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double x = static_cast<double>(i) / samples, theta = 2 * std::numbers::pi * x;
    EXPECT_NEAR(ellipse(i, 0), 1.4 * std::cos(theta), rounding);
    EXPECT_NEAR(ellipse(i, 1), 0.6 * std::sin(theta), rounding);
    EXPECT_NEAR(star.row(i).norm(), 1 + 0.3 * std::cos(5 * theta), rounding);
    EXPECT_NEAR(dent.row(i).norm(), 1 - 0.6 * std::exp(-std::pow((x - 0.3) / 0.05, 2)), rounding);
    EXPECT_NEAR(std::atan2(dent(i, 1), dent(i, 0)), std::remainder(theta, 2 * std::numbers::pi),
                i == samples / 2 ? 7 : rounding);  // there the angle is pi or -pi
  }
}

TEST(NamedShapes, RefusesAnotherNameAndNamesTheKnown) {
  try {
    named_shape("blob", samples);
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    for (const char* part : {"blob", "ellipse", "star", "dent"}) {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
}

TEST(FittedToCircle, UndoesPlaceScaleAndStart) {
  const Contour circle = unit_circle(samples);
  Contour moved(samples, 2);
  for (Eigen::Index i = 0; i < samples; ++i) moved.row(i) = 7 * circle.row((i + 23) % samples);
  moved.rowwise() += Eigen::RowVector2d(100, -50);
  EXPECT_LT((fitted_to_circle(moved) - circle).norm(), 1e-11);  // 100 / 7 times the rounding
  EXPECT_THROW(fitted_to_circle(Contour::Ones(samples, 2)), std::invalid_argument);
}

TEST(Released, TakesSamplesAsCoefficientsAndStartsAtRest) {
  const dynamics::LagrangeSystem system(find_filter_bank<double>("db4"), samples,
                                        all_levels(samples), {});
  const Contour star = named_shape("star", samples);
  const dynamics::InitialValueProblem problem =
      released(system, star, Eigen::VectorXd::LinSpaced(3, 0, 1));
  const Contour start = problem.rest + problem.initial_displacement;
  EXPECT_LT((to_samples(system.bank(), start, system.levels()) - star).norm(), 1e-12);
  EXPECT_EQ(problem.initial_velocity.size(), 0);
}

}  // namespace
}  // namespace wavecurve::verification
