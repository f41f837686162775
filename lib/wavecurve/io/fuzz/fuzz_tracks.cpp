#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "wavecurve/io/fuzz/check_drawing_test.hpp"
#include "wavecurve/io/tracks/detail/track_table.hpp"

namespace {

/// What every table of tracks promises.
void check(const wavecurve::io::TrackTable& table) {
  using wavecurve::io::demand;
  const Eigen::Index frames = table.tracks.times.size();
  demand(frames >= 2 && !table.tracks.limbs.empty());
  for (Eigen::Index i = 1; i < frames; ++i) {
    demand(table.tracks.times[i] > table.tracks.times[i - 1]);
  }
  for (const wavecurve::gait::LimbTrack& limb : table.tracks.limbs) {
    demand(limb.outlines.size() == static_cast<std::size_t>(frames));
    for (const wavecurve::Contour& points : limb.outlines) {
      demand(points.rows() >= (table.joints ? 2 : 4) && points.allFinite());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(bytes), size);
    check(wavecurve::io::read_track_table(text, {}));
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
