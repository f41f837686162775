// Writes docs/examples/dog-walk.csv: the joints of the limbs of the dog in dog.svg, walking in
// place, three cycles of 32 frames. Usage: generate_dog_walk OUT.csv
#include <exception>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/motion/gait/record/canine_joints.hpp"

namespace {

using namespace wavecurve;

constexpr int cycles = 3, frames_a_cycle = 32;
constexpr double period = 0.8;  // seconds

const std::vector<std::string>& joint_names(const std::string& limb) {
  static const std::vector<std::string> fore{"scapula", "shoulder", "elbow",
                                             "carpus",  "knuckle",  "toe"};
  static const std::vector<std::string> hind{"hip", "stifle", "hock", "knuckle", "toe"};
  return limb[1] == 'F' ? fore : hind;
}

std::string dog_walk() {
  const Eigen::VectorXd phases =
      Eigen::VectorXd::LinSpaced(cycles * frames_a_cycle, 0, cycles * frames_a_cycle - 1) /
      frames_a_cycle;
  const gait::LimbTracks walk =
      gait::canine_joints(gait::drawn_dog(), gait::find_canine_gait("walk"), phases);
  std::string text =
      "# The walk of the dog in dog.svg, written by generate_dog_walk; sources in "
      "canine_joints.hpp and canine_gaits.hpp\nframe,t,limb,joint,x,y\n";
  for (Eigen::Index i = 0; i < phases.size(); ++i) {
    for (const gait::LimbTrack& limb : walk.limbs) {
      const std::vector<std::string>& names = joint_names(limb.limb);
      const Contour& joints = limb.outlines[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < names.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        text += fmt::format("{},{:.3f},{},{},{:.3f},{:.3f}\n", i, phases[i] * period, limb.limb,
                            names[k], joints(row, 0), joints(row, 1));
      }
    }
  }
  return text;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::cerr << "usage: generate_dog_walk OUT.csv\n";
    return 2;
  }
  io::write_file(arguments[1], dog_walk());
  return 0;
} catch (const std::exception& error) {
  std::cerr << "generate_dog_walk: " << error.what() << '\n';
  return 3;
}
