#include "wavecurve/motion/detail/blend_paint.hpp"

#include <cmath>
#include <set>

#include "wavecurve/motion/detail/oklab.hpp"

namespace wavecurve::motion {

namespace {

/// What the other paint has and this one lacks, without extent: a stroke of no width, which has the
/// colour of what is there; a fill, whose outline has no area (make_morph sees to that).
void complete(Paint& paint, const Paint& other) {
  const Paint own = paint;
  if (!own.stroke && other.stroke) {
    const bool becomes_outline = own.fill && !other.fill;
    paint.stroke = becomes_outline ? own.fill : other.stroke;
    paint.stroke_opacity = becomes_outline ? own.fill_opacity : other.stroke_opacity;
    paint.stroke_width = 0;
    paint.line_cap = other.line_cap;
    paint.line_join = other.line_join;
    paint.miter_limit = other.miter_limit;
  }
  if (!own.fill && other.fill) {
    const bool becomes_solid = own.stroke && !other.stroke;
    paint.fill = becomes_solid ? own.stroke : other.fill;
    paint.fill_opacity = becomes_solid ? own.stroke_opacity : other.fill_opacity;
  }
}

bool is_evenodd(const Paint& paint) { return paint.fill && paint.fill_rule == FillRule::evenodd; }

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
  const bool switches = start.line_cap != end.line_cap || start.line_join != end.line_join;
  if (switches) shares.insert(0.5);
  std::vector<PaintKey> keys;
  for (const double share : shares) {
    Paint paint;
    paint.fill = colour_at(fill, share);
    paint.stroke = colour_at(stroke, share);
    paint.fill_opacity = std::lerp(start.fill_opacity, end.fill_opacity, share);
    paint.stroke_opacity = std::lerp(start.stroke_opacity, end.stroke_opacity, share);
    paint.stroke_width = std::lerp(start.stroke_width, end.stroke_width, share);
    paint.fill_rule = is_evenodd(from) || is_evenodd(to) ? FillRule::evenodd : FillRule::nonzero;
    paint.line_cap = share < 0.5 ? start.line_cap : end.line_cap;
    paint.line_join = share < 0.5 ? start.line_join : end.line_join;
    paint.miter_limit = std::lerp(start.miter_limit, end.miter_limit, share);
    keys.push_back({share * duration, paint});
  }
  return keys;
}

Paint vanishing(Paint paint) {
  paint.stroke_width = 0;
  return paint;
}

}  // namespace wavecurve::motion
