#include "wavecurve/motion/detail/blend_paint.hpp"

#include <cmath>
#include <set>

#include "wavecurve/motion/detail/oklab.hpp"

namespace wavecurve::motion {

namespace {

/// What the other paint has and this one lacks, invisible.
void complete(Paint& paint, const Paint& other) {
  if (!paint.fill && other.fill) {
    paint.fill = other.fill;
    paint.fill_opacity = 0;
  }
  if (!paint.stroke && other.stroke) {
    paint.stroke = other.stroke;
    paint.stroke_opacity = 0;
    paint.stroke_width = other.stroke_width;
  }
}

std::vector<ColourStop> stops(const std::optional<Colour>& from, const std::optional<Colour>& to) {
  if (!from || !to) return {};
  return colour_line(*from, *to);
}

std::optional<Colour> colour_at(const std::vector<ColourStop>& line, double share) {
  if (line.empty()) return std::nullopt;
  std::size_t next = 1;
  while (line[next].share < share) ++next;
  const ColourStop &left = line[next - 1], &right = line[next];
  const double inner = (share - left.share) / (right.share - left.share);
  return Colour{std::lerp(left.colour.red, right.colour.red, inner),
                std::lerp(left.colour.green, right.colour.green, inner),
                std::lerp(left.colour.blue, right.colour.blue, inner)};
}

}  // namespace

std::vector<PaintKey> blend_paint(const Paint& from, const Paint& to, double duration) {
  Paint start = from, end = to;
  complete(start, to);
  complete(end, from);
  const auto fill = stops(start.fill, end.fill), stroke = stops(start.stroke, end.stroke);
  std::set<double> shares{0, 1};
  for (const ColourStop& stop : fill) shares.insert(stop.share);
  for (const ColourStop& stop : stroke) shares.insert(stop.share);
  const bool is_evenodd = from.fill_rule == FillRule::evenodd && to.fill_rule == FillRule::evenodd;
  std::vector<PaintKey> keys;
  for (const double share : shares) {
    Paint paint;
    paint.fill = colour_at(fill, share);
    paint.stroke = colour_at(stroke, share);
    paint.fill_opacity = std::lerp(start.fill_opacity, end.fill_opacity, share);
    paint.stroke_opacity = std::lerp(start.stroke_opacity, end.stroke_opacity, share);
    paint.stroke_width = std::lerp(start.stroke_width, end.stroke_width, share);
    paint.fill_rule = is_evenodd ? FillRule::evenodd : FillRule::nonzero;
    keys.push_back({share * duration, paint});
  }
  return keys;
}

Paint vanishing(Paint paint) {
  paint.stroke_opacity = 0;
  return paint;
}

}  // namespace wavecurve::motion
