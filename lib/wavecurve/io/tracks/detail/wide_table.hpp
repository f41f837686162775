#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/io/files/detail/table_rows.hpp"
#include "wavecurve/io/tracks/detail/track_table.hpp"

namespace wavecurve::io {

/// Reads a table of joints with a line a frame: that of DeepLabCut, whose header has the lines scorer, bodyparts
/// and coords, that of SLEAP, and others whose columns are called after joints, NAME_x and NAME_y or
/// NAME.x and NAME.y, with NAME_likelihood if they like. What read_limb_tracks says holds.
class WideTable {
 public:
  /// Whether the first row of a table is the header of such a one.
  static bool is_header(const std::vector<std::string>& cells);

  WideTable(const std::vector<std::string>& wanted, double least_likelihood)
      : wanted_(wanted), least_likelihood_(least_likelihood) {}

  void read_row(const TableRow& row);
  TrackTable finish();

 private:
  struct Joint {
    std::string name;  ///< of the limb and of the joint in it
    std::optional<std::size_t> x, y, likelihood;
    std::vector<Eigen::RowVector2d> points;  ///< one a row; not finite where it is missing
  };
  struct Limb {
    std::string name;
    std::vector<Joint*> joints;
  };

  void read_header(const TableRow& row);
  void add_column(std::string_view joint, std::string_view kind, std::size_t column);
  void end_header(int line);
  void check_animal(const TableRow& row);
  std::vector<Limb> limbs();
  void fill_frames();
  void interpolate(Joint& joint);
  Eigen::VectorXd times() const;

  const std::vector<std::string>& wanted_;
  double least_likelihood_;
  std::vector<std::vector<std::string>> header_;  ///< of DeepLabCut, until it is read
  std::size_t width_ = 0;                         ///< the number of columns, once it is known
  std::optional<std::size_t> frame_, time_, track_;
  std::string animal_;
  std::vector<Joint> joints_;
  std::vector<double> frames_, row_times_;
  std::size_t absent_frames_ = 0;
  std::vector<std::string> warnings_;
};

}  // namespace wavecurve::io
