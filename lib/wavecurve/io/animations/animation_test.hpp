#pragma once

#include <cmath>
#include <numbers>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/morph/morph.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

/// Drawings for the tests of writers and players.
namespace wavecurve::io {

/// A circle whose radius varies by a share, a number of times around.
inline Contour flower(double x, double y, double radius, Eigen::Index points, double share = 0,
                      int petals = 1) {
  Contour contour(points, 2);
  for (Eigen::Index i = 0; i < points; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double r = radius * (1 + share * std::cos(petals * angle));
    contour.row(i) << x + r * std::cos(angle), y + r * std::sin(angle);
  }
  return contour;
}

inline Contour square(double x, double y, double half_side, Eigen::Index points) {
  const Eigen::Vector2d corners[] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  Contour contour(points, 2);
  for (Eigen::Index i = 0; i < points; ++i) {
    const Eigen::Index side = 4 * i / points;
    const double share =
        4.0 * static_cast<double>(i) / static_cast<double>(points) - static_cast<double>(side);
    const Eigen::Vector2d at = (1 - share) * corners[side] + share * corners[(side + 1) % 4];
    contour.row(i) << x + half_side * at.x(), y + half_side * at.y();
  }
  return contour;
}

inline Paint filled(double red, double green, double blue) {
  Paint paint;
  paint.fill = Colour{red, green, blue};
  return paint;
}

inline Paint stroked(double red, double green, double blue, double width) {
  Paint paint;
  paint.stroke = Colour{red, green, blue};
  paint.stroke_width = width;
  return paint;
}

/// Everything that a layer can have: a change of colour, a hole by the even-odd rule, a stroke with
/// a fill that fades, an outline at rest at first and in the end, an id that needs care.
inline motion::Animation sample_animation() {
  Paint ring = filled(0.8, 0.1, 0.2), faded = ring;
  ring.fill_rule = faded.fill_rule = FillRule::evenodd;
  ring.stroke = faded.stroke = Colour{0, 0, 0.4};
  ring.stroke_width = 2;
  faded.stroke_width = 4;
  faded.fill_opacity = 0.5;
  motion::Animation animation{{-10, 5, 100, 80}, 2, {}};
  animation.layers.push_back(
      {"face",
       {{0, {flower(40, 45, 30, 256)}}, {2, {flower(40, 45, 28, 256, 0.2, 5)}}},
       {{0, filled(1, 0.8, 0.2)}, {2, filled(0.3, 0.6, 1)}}});
  animation.layers.push_back(
      {"<ring> & \"hole\"",
       {{0, {square(25, 30, 12, 256), flower(25, 30, 6, 64)}},
        {2, {flower(60, 60, 15, 256, 0.3, 4), flower(60, 60, 6, 64, 0.2, 3)}}},
       {{0, ring}, {2, faded}}});
  animation.layers.push_back({"line",
                              {{0.5, {square(60, 25, 8, 64)}}, {1.5, {flower(20, 65, 10, 64)}}},
                              {{0, stroked(0.1, 0.4, 0.1, 3)}}});
  return animation;
}

/// What a morph of drawings may have besides: two layers that change places half-way, an open line
/// whose square caps become round then, a stroke that loses its width.
inline motion::Animation exchange_animation() {
  Paint line = stroked(0.1, 0.4, 0.1, 6), rounded = line, thick = stroked(0.4, 0, 0.4, 4);
  line.line_cap = LineCap::square;
  rounded.line_cap = LineCap::round;
  Paint gone = thick;
  gone.stroke_width = 0;
  const Contour corner = (Contour(3, 2) << 60, 20, 80, 20, 80, 60).finished();
  motion::Animation animation{{-10, 5, 100, 80}, 2, {}};
  animation.layers = {{"red", {{0, {square(20, 40, 20, 64)}}}, {{0, filled(0.8, 0, 0)}}},
                      {"blue", {{0, {square(30, 50, 20, 64)}}}, {{0, filled(0, 0, 0.8)}}},
                      {"line",
                       {{0, {corner}}, {2, {corner.rowwise() + Eigen::RowVector2d(0, 10)}}},
                       {{0, line}, {1, rounded}, {2, rounded}},
                       {true}},
                      {"gone",
                       {{0, {square(75, 70, 8, 64)}}, {2, {Contour::Constant(64, 2, 70)}}},
                       {{0, thick}, {2, gone}}}};
  animation.order = {{1, {1, 0, 2, 3}}};
  return animation;
}

/// Coefficients of the samples, in global-to-local order.
inline Contour coefficients_of(const Contour& samples, const FilterBank<double>& bank, int levels) {
  const PeriodicTransform<> transform(bank, samples.rows(), levels);
  Eigen::VectorXd workspace(transform.workspace_size());
  Contour result(samples.rows(), 2);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    transform.forward(samples.col(axis), result.col(axis), workspace);
  }
  return result;
}

/// Two layers of 256 points on 4 levels, with different scales.
inline motion::Morph sample_morph(motion::Detail detail) {
  motion::Morph morph;
  morph.view_box = {-10, 5, 100, 80};
  morph.bank = find_filter_bank("D8");
  morph.levels = 4;
  morph.detail = detail;
  morph.duration = 2;
  const auto pair = [&](const Contour& a, const Contour& b) {
    return motion::ContourPair{coefficients_of(a, morph.bank, 4),
                               coefficients_of(b, morph.bank, 4)};
  };
  morph.layers.push_back({"face",
                          {pair(flower(40, 45, 25, 256, 0.1, 40), flower(40, 45, 28, 256, 0.2, 5))},
                          {{0, filled(1, 0.8, 0.2)}, {2, filled(0.3, 0.6, 1)}},
                          16});
  morph.layers.push_back({"square",
                          {pair(square(25, 30, 12, 256), flower(60, 60, 15, 256, 0.3, 4))},
                          {{0, filled(0.8, 0.1, 0.2)}},
                          32});
  return morph;
}

}  // namespace wavecurve::io
