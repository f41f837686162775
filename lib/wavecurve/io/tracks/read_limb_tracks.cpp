#include "wavecurve/io/tracks/read_limb_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/io/files/detail/natural_order.hpp"
#include "wavecurve/io/files/detail/read_gzip.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/tracks/detail/track_table.hpp"
#include "wavecurve/motion/gait/record/detail/body_frame.hpp"
#include "wavecurve/motion/gait/record/detail/skin_joints.hpp"
#include "wavecurve/motion/gait/record/detail/track_outlines.hpp"

namespace wavecurve::io {

namespace {

using Eigen::Index;
using Path = std::filesystem::path;

constexpr Index usual_samples = 256;

enum class Source { table, joints, drawings };

bool has_ending(const Path& path, std::string_view ending) {
  return lower_case(path.filename().string()).ends_with(ending);
}

std::vector<Path> frames_in(const Path& folder) {
  std::vector<Path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (has_ending(entry.path(), ".svg")) files.push_back(entry.path());
  }
  const auto by_number = [](const Path& a, const Path& b) {
    return naturally_precedes(a.filename().string(), b.filename().string());
  };
  std::sort(files.begin(), files.end());
  std::stable_sort(files.begin(), files.end(), by_number);
  return files;
}

TrackTable read_table(const Path& path, const TrackOptions& options) {
  const std::string text = read_gzip(path, largest_input);
  const auto refuse = [&](std::string_view defect) {
    throw std::invalid_argument(fmt::format("{}: {}", path.string(), defect));
  };
  if (text.empty()) refuse("the file is empty");
  if (text.size() > largest_input) refuse(fmt::format("larger than {} bytes", largest_input));
  TrackTable table;
  try {
    table = read_track_table(text, options.limbs, options.least_likelihood);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  if (table.joints && !table.treadmill) gait::take_out_travel(table.tracks);
  const bool detected = options.y_axis == YAxis::detected;
  if (detected ? gait::y_points_up(table.tracks) : options.y_axis == YAxis::up) {
    for (gait::LimbTrack& track : table.tracks.limbs) {
      for (Contour& points : track.outlines) points.col(1) *= -1;
    }
  }
  return table;
}

Contour largest_outline(const Layer& layer, Index samples) {
  const std::vector<Contour> all = sample_layer(layer, samples);
  const auto smaller = [](const Contour& a, const Contour& b) {
    return std::abs(signed_area(a)) < std::abs(signed_area(b));
  };
  return *std::max_element(all.begin(), all.end(), smaller);
}

/// The named layers; none: those of the first frame, which then must have no others later.
void add_frame(gait::LimbTracks& tracks, const Path& path, const TrackOptions& options) {
  const Drawing drawing = read_drawing(path).drawing;
  const auto refuse = [&](const std::string& layer, std::string_view defect) {
    throw std::invalid_argument(fmt::format("{}: layer {} {}", path.string(), layer, defect));
  };
  if (tracks.limbs.empty()) {
    for (const std::string& name : options.limbs) tracks.limbs.push_back({name, {}});
    if (options.limbs.empty()) {
      for (const Layer& layer : drawing.layers) tracks.limbs.push_back({layer.id, {}});
    }
  }
  // So fine that sampling it once more, in the course of tracking, does not show.
  const Index fine = 4 * (options.samples > 0 ? options.samples : usual_samples);
  std::set<std::string> unseen;
  for (const Layer& layer : drawing.layers) unseen.insert(layer.id);
  for (gait::LimbTrack& limb : tracks.limbs) {
    const auto layer = std::find_if(drawing.layers.begin(), drawing.layers.end(),
                                    [&](const Layer& one) { return one.id == limb.limb; });
    if (layer == drawing.layers.end()) refuse(limb.limb, "is missing; it must be in all frames");
    limb.outlines.push_back(largest_outline(*layer, fine));
    unseen.erase(limb.limb);
  }
  if (options.limbs.empty() && !unseen.empty())
    refuse(*unseen.begin(), "is not in the first frame");
}

TrackTable read_frames(const std::vector<Path>& paths, const TrackOptions& options) {
  std::error_code ignored;
  const bool folder = paths.size() == 1 && std::filesystem::is_directory(paths[0], ignored);
  const std::vector<Path> frames = folder ? frames_in(paths[0]) : paths;
  if (frames.size() < 2) {
    throw std::invalid_argument(fmt::format("{}: {} SVG frame{}; at least 2 are needed",
                                            paths[0].string(), frames.size(),
                                            frames.size() == 1 ? "" : "s"));
  }
  TrackTable table;
  const auto count = static_cast<Index>(frames.size());
  table.tracks.times = Eigen::VectorXd::LinSpaced(count, 0, static_cast<double>(count - 1));
  for (const Path& frame : frames) add_frame(table.tracks, frame, options);
  return table;
}

/// Clockwise as seen, on the mean over time; the first point stays the first.
void turn_clockwise(gait::LimbTrack& track) {
  double area = 0;
  for (const Contour& outline : track.outlines) area += signed_area(outline);
  if (area >= 0) return;
  for (Contour& outline : track.outlines) {
    const Index rest = outline.rows() - 1;
    outline.bottomRows(rest) = outline.bottomRows(rest).colwise().reverse().eval();
  }
}

/// The file's own number, if it may be kept.
Index samples_of(const gait::LimbTrack& track, bool table, const TrackOptions& options) {
  if (options.samples > 0) return options.samples;
  const Index count = track.outlines[0].rows();
  const auto differs = [&](const Contour& outline) { return outline.rows() != count; };
  const bool same = std::none_of(track.outlines.begin(), track.outlines.end(), differs);
  return table && same && is_power_of_two(count) ? count : usual_samples;
}

void set_outlines(gait::LimbTrack& track, Source source, const TrackOptions& options) {
  if (source == Source::joints) {
    const double radius = options.thickness * gait::chain_length(track.outlines) / 2;
    const Index samples = options.samples > 0 ? options.samples : usual_samples;
    track.outlines = gait::skin_joints(track.outlines, radius, samples);
    return;
  }
  turn_clockwise(track);
  const Index samples = samples_of(track, source == Source::table, options);
  if (track.outlines[0].rows() == samples && gait::correspond(track.outlines)) return;
  track.outlines = gait::track_outlines(track.outlines, samples);
}

}  // namespace

gait::LimbTracks read_limb_tracks(const std::vector<Path>& paths, const TrackOptions& options,
                                  std::vector<std::string>* warnings) {
  if (paths.empty()) throw std::invalid_argument("0 files of tracks; at least 1 is needed");
  if (options.samples != 0) check_samples(options.samples);
  const auto refuse = [&](std::string_view defect) {
    throw std::invalid_argument(fmt::format("{}: {}", paths[0].string(), defect));
  };
  std::error_code ignored;  // a circle of links leads to no file either
  if (!std::filesystem::exists(paths[0], ignored)) refuse("there is no such file or folder");
  const bool is_table = has_ending(paths[0], ".csv") || has_ending(paths[0], ".csv.gz");
  if (is_table && paths.size() > 1) refuse("a table holds all frames; give no other file with it");
  TrackTable table = is_table ? read_table(paths[0], options) : read_frames(paths, options);
  const Source source = table.joints ? Source::joints : is_table ? Source::table : Source::drawings;
  for (gait::LimbTrack& track : table.tracks.limbs) {
    try {
      set_outlines(track, source, options);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("limb {}: {}", track.limb, error.what()));
    }
  }
  if (warnings) warnings->insert(warnings->end(), table.warnings.begin(), table.warnings.end());
  return table.tracks;
}

}  // namespace wavecurve::io
