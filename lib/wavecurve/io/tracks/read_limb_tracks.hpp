#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::io {

/// Which way y points in a file.
enum class YAxis { detected, down, up };

struct TrackOptions {
  std::vector<std::string> limbs{};  ///< those that are read; none: all that are there
  Eigen::Index samples = 0;        ///< points of an outline, a power of two; 0: as the file has it
  double thickness = 0.12;         ///< of skinned limbs, as a share of the length of their joints
  YAxis y_axis = YAxis::detected;  ///< of tables; in SVG it points down
  double least_likelihood = 0.6;   ///< of a point, below which it is taken for missing
};

/// Reads the traced limbs of an animal: from one table, from SVG frames in the order given, or from
/// a folder of SVG frames, which are ordered by the numbers in their names.
///
/// Tables, `.csv` or `.csv.gz`, have a header and a line a point, in any order of columns:
///   frame, limb or contour, k, x, y       point k = 0, 1, ... of the outline of a limb
///   frame, limb, joint, x, y              joints from the body to the toe, skinned (skin_joints)
/// and, if they like, t, the time of the frame. A unit may follow a name, as in y_m. Of
/// x_treadmill, x and x_world the first that is there is read; a column `visible` and others are
/// not. Without t, frames are evenly spaced, and their numbers are the times.
///
/// Or a table has a line a frame, and columns that are called after the joints: as DeepLabCut writes it (a
/// header of scorer, bodyparts and coords), SLEAP, or frame, LF_hip_x, LF_hip_y, LF_toe_x, ... Limbs
/// are taken from the names (LF_toe, toe_FL, front_left_paw), joints from the body to the toe by their
/// names (hip, knee, hock, toe) or else in the order of the columns. Points that are missing or whose
/// likelihood is below the bound are interpolated linearly in time, and at the ends are the nearest.
///
/// SVG frames hold a layer a limb, whose id is its name, and are times 0, 1, ... Where a layer
/// has several subpaths, the largest is the outline.
///
/// What comes out is in the frame of the body (take_out_travel, for joints without x_treadmill), y
/// points down (y_points_up detects it), and outlines are clockwise as seen. Where the number of
/// points is no power of two, differs between frames, or the first point jumps, they are sampled
/// anew and the first point is tracked (track_outlines); otherwise they stay as they are.
///
/// Throws std::invalid_argument naming the file, the line, the value and the bound: for a limb, a
/// frame, a point or a joint that is not everywhere, fewer than two frames, times that do not
/// increase, outlines of fewer than 4 points, and what is no finite number within +-1e9. Files of
/// at most 256 MiB, unpacked, are read. Throws std::system_error if reading fails. What was interpolated,
/// and columns that belong to no limb, are said in lines that are added to `warnings`.
gait::LimbTracks read_limb_tracks(const std::vector<std::filesystem::path>& paths,
                                  const TrackOptions& options = {},
                                  std::vector<std::string>* warnings = nullptr);

}  // namespace wavecurve::io
