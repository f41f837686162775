#include "wavecurve/motion/morph/detail/covered_intervals.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace wavecurve::motion {

namespace {

/// Where a line meets an outline, and whether that goes up or down there.
struct Meeting {
  double x;
  int winding;
};

void add_meetings(const Contour& contour, const ViewBox& box,
                  std::vector<std::vector<Meeting>>& meetings) {
  const double height = box.height / static_cast<double>(meetings.size());
  const auto line_after = [&](double y) {
    const double line = std::ceil((y - box.y) / height - 0.5);
    return static_cast<std::size_t>(std::clamp(line, 0.0, static_cast<double>(meetings.size())));
  };
  for (Eigen::Index i = 0; i < contour.rows(); ++i) {
    Eigen::RowVector2d a = contour.row(i), b = contour.row((i + 1) % contour.rows());
    const int winding = a.y() > b.y() ? -1 : 1;
    if (winding < 0) std::swap(a, b);
    for (std::size_t line = line_after(a.y()); line < line_after(b.y()); ++line) {
      const double y = box.y + (static_cast<double>(line) + 0.5) * height;
      meetings[line].push_back({a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()), winding});
    }
  }
}

bool is_inside(int winding, FillRule rule) {
  return rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
}

/// Appends an interval, or prolongs the last one if that reaches it.
void add_interval(std::vector<std::pair<double, double>>& intervals, double from, double to) {
  if (intervals.empty() || intervals.back().second < from) {
    intervals.emplace_back(from, to);
  } else {
    intervals.back().second = std::max(intervals.back().second, to);
  }
}

Eigen::AlignedBox2d box_of(const FrameLayer& layer) {
  Eigen::AlignedBox2d box;
  for (const Contour& contour : layer.contours) {
    for (const auto& point : contour.rowwise()) box.extend(Eigen::Vector2d(point.transpose()));
  }
  return box;
}

}  // namespace

CoveredIntervals covered_intervals(const FrameLayer& layer, const ViewBox& box, std::size_t lines) {
  std::vector<std::vector<Meeting>> meetings(lines);
  for (const Contour& contour : layer.contours) add_meetings(contour, box, meetings);
  const Paint& paint = layer.paint;
  const double margin = paint.stroke ? paint.stroke_width / 2 : 0;
  CoveredIntervals covered(lines);
  for (std::size_t line = 0; line < lines; ++line) {
    std::ranges::sort(meetings[line], {}, &Meeting::x);
    int winding = 0;
    double from = 0;
    for (const Meeting& meeting : meetings[line]) {
      const bool was_inside = is_inside(winding, paint.fill_rule);
      winding += meeting.winding;
      if (paint.stroke && !paint.fill) {
        add_interval(covered[line], meeting.x - margin, meeting.x + margin);
      } else if (!was_inside) {
        from = meeting.x;
      } else if (!is_inside(winding, paint.fill_rule)) {
        add_interval(covered[line], from - margin, meeting.x + margin);
      }
    }
  }
  return covered;
}

double shared_length(const CoveredIntervals& a, const CoveredIntervals& b) {
  double length = 0;
  for (std::size_t line = 0; line < std::min(a.size(), b.size()); ++line) {
    auto p = a[line].begin();
    auto q = b[line].begin();
    while (p != a[line].end() && q != b[line].end()) {
      length += std::max(0.0, std::min(p->second, q->second) - std::max(p->first, q->first));
      if (p->second < q->second) {
        ++p;
      } else {
        ++q;
      }
    }
  }
  return length;
}

bool share_area(const FrameLayer& a, const FrameLayer& b) {
  constexpr std::size_t lines = 64;
  const Eigen::AlignedBox2d box = box_of(a).intersection(box_of(b));
  if (box.isEmpty() || !(box.sizes().minCoeff() > 0)) return false;
  const ViewBox common{box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y()};
  const double rounding = 1e-9 * common.width;
  return shared_length(covered_intervals(a, common, lines), covered_intervals(b, common, lines)) >
         rounding;
}

}  // namespace wavecurve::motion
