#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/io/animations/output_options.hpp"

namespace wavecurve::tools {

/// The options about how an animation leaves, which the commands that write one share.
class AnimationOutput {
 public:
  /// --output, --frames, --fps, --size, --background, --tolerance, --sheet; the text says how many
  /// frames there are by default.
  void add_to(CLI::App* command, const std::string& default_frames);

  /// Throws std::invalid_argument for what the format of the output does not have.
  void check() const;

  const std::string& path() const { return path_; }
  std::string ending() const;
  bool is_sheet() const { return is_sheet_; }
  bool has_tolerance() const { return tolerance_.has_value(); }
  std::optional<int> frames() const { return frames_; }
  std::optional<double> rate() const { return rate_; }
  CLI::Option* sheet() const { return sheet_; }

  /// The number of steps from frame to frame in so many seconds: at the rate asked for, rounded. Throws
  /// std::invalid_argument for none, and for more than frames_check allows.
  int steps(double seconds) const;

  /// For a drawing of this box. Without --tolerance, points may be off by a tenth of a pixel.
  io::OutputOptions options(const ViewBox& box) const;

 private:
  std::string path_, background_, size_;
  std::optional<int> frames_;
  std::optional<double> rate_, tolerance_;
  bool is_sheet_ = false;
  CLI::Option* sheet_ = nullptr;
};

}  // namespace wavecurve::tools
