#include "verification/study/named_shapes.hpp"

#include <cmath>
#include <complex>
#include <filesystem>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <fmt/ranges.h>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/exponential.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::Index;
using Point = Eigen::RowVector2d;

Contour traced(Index samples, const std::function<Point(double)>& point) {
  Contour contour(samples, 2);
  for (Index i = 0; i < samples; ++i) {
    contour.row(i) = point(static_cast<double>(i) / static_cast<double>(samples));
  }
  return contour;
}

Point on_circle(double x) {
  const double angle = 2 * std::numbers::pi * x;
  return {cosine(angle), sine(angle)};
}

bool is_file(const std::string& name) {
  const std::string ending = std::filesystem::path(name).extension().string();
  return ending == ".svg" || ending == ".csv";
}

}  // namespace

Contour unit_circle(Index samples) { return traced(samples, on_circle); }

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names = {"ellipse", "star", "dent"};
  return names;
}

Contour named_shape(std::string_view name, Index samples) {
  if (name == "ellipse") {
    return traced(samples,
                  [](double x) -> Point { return on_circle(x).cwiseProduct(Point(1.4, 0.6)); });
  }
  if (name == "star") {
    return traced(samples, [](double x) -> Point {
      return (1 + 0.3 * cosine(10 * std::numbers::pi * x)) * on_circle(x);
    });
  }
  if (name == "dent") {
    return traced(samples, [](double x) -> Point {
      const double place = (x - 0.3) / 0.05;
      return (1 - 0.6 * exponential(-place * place)) * on_circle(x);
    });
  }
  std::vector<std::string> known = shape_names();
  known.emplace_back("a file ending in .svg or .csv");
  throw std::invalid_argument(unknown_name("shape", name, known));
}

Contour deformed_hoop(Index samples) {
  return traced(samples, [](double x) -> Point {
    const double w = 0.12 * cosine(10 * std::numbers::pi * x);
    return on_circle(x).cwiseProduct(Point(1.3 + w, 0.65 + w)) +
           Point(0, 0.3 * cosine(4 * std::numbers::pi * x));
  });
}

Contour fitted_to_circle(const Contour& contour) {
  const Index samples = contour.rows();
  Contour centred = contour.rowwise() - contour.colwise().mean();
  const double radius = centred.norm() / std::sqrt(static_cast<double>(samples));
  if (!(radius > 0)) throw std::invalid_argument("shape has length 0, but must be a curve");
  centred /= radius;
  // The inner product of circle and points shifted by s is Re(z e^{2 pi i s / samples}).
  std::complex<double> z = 0;
  for (Index i = 0; i < samples; ++i) {
    const Point circle = on_circle(static_cast<double>(i) / static_cast<double>(samples));
    z += std::complex(centred(i, 0), centred(i, 1)) * std::complex(circle[0], -circle[1]);
  }
  const double turn =
      -arctangent(z.imag(), z.real()) / (2 * std::numbers::pi) * static_cast<double>(samples);
  const Index shift = (std::lround(turn) + samples) % samples;
  Contour fitted(samples, 2);
  for (Index i = 0; i < samples; ++i) fitted.row(i) = centred.row((i + shift) % samples);
  return fitted;
}

Contour shape_of(const std::string& name_or_file, Index samples) {
  if (!is_file(name_or_file)) return named_shape(name_or_file, samples);
  const Drawing drawing = io::read_drawing(name_or_file).drawing;
  return fitted_to_circle(sample_contour(drawing.layers.at(0).subpaths.at(0), samples));
}

dynamics::InitialValueProblem released(const dynamics::LagrangeSystem& system, const Contour& shape,
                                       const Eigen::Ref<const Eigen::VectorXd>& times) {
  const auto coefficients = [&](const Contour& samples) -> Eigen::MatrixXd {
    return to_coefficients(system.bank(), samples, system.levels());
  };
  const Contour circle = unit_circle(system.samples());
  return {.system = system,
          .initial_displacement = coefficients(shape - circle),
          .times = times,
          .rest = coefficients(circle)};
}

}  // namespace wavecurve::verification
