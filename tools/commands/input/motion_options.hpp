#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "wavecurve/motion/morph/physical_motion.hpp"

namespace wavecurve::tools {

/// --motion and the options of physical motion, of one command.
class MotionOptions {
 public:
  void add_to(CLI::App* command);

  bool is_physical() const { return motion_ == "physical"; }
  /// Throws std::invalid_argument for an option of physical motion without --motion physical.
  void check() const;
  /// Throws std::invalid_argument for an --until that is neither a number nor `settled`.
  motion::PhysicalOptions physical(int frames) const;

 private:
  std::string motion_ = "linear", until_ = "settled";
  motion::PhysicalOptions options_;
  std::vector<double> damping_;  ///< mass, stiffness and maybe density
  std::vector<double> force_;
  std::vector<CLI::Option*> of_physical_;
};

}  // namespace wavecurve::tools
