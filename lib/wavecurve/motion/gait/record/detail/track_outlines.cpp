#include "wavecurve/motion/gait/record/detail/track_outlines.hpp"

#include <algorithm>
#include <cstddef>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"

namespace wavecurve::gait {

using Eigen::Index;

std::vector<Contour> track_outlines(const std::vector<Contour>& traced, Index samples) {
  constexpr Index finer = 4;
  check_samples(samples);
  std::vector<Contour> outlines;
  Contour before;
  for (const Contour& outline : traced) {
    Contour fine = sample_contour(outline, finer * samples);
    if (before.rows() > 0) {
      fine = started_at(fine, best_shift(before, fine, Rotation::taken_out));
    }
    Contour coarse(samples, 2);
    for (Index i = 0; i < samples; ++i) coarse.row(i) = fine.row(finer * i);
    outlines.push_back(std::move(coarse));
    before = std::move(fine);
  }
  return outlines;
}

bool correspond(const std::vector<Contour>& outlines) {
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Index count = outlines[i].rows();
    if (count != outlines[0].rows() || count < fewest_samples || !is_power_of_two(count)) {
      return false;
    }
    if (i == 0) continue;
    const Index shift = best_shift(outlines[i - 1], outlines[i], Rotation::taken_out);
    if (32 * std::min(shift, count - shift) > count) return false;
  }
  return true;
}

}  // namespace wavecurve::gait
