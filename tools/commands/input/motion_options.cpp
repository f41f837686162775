#include "tools/commands/input/motion_options.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

#include "tools/commands/input/number_option.hpp"

namespace wavecurve::tools {

namespace {

/// Squares and products of a few such numbers are finite.
constexpr double largest = 1e12;

}  // namespace

void MotionOptions::add_to(CLI::App* command) {
  command
      ->add_option(
          "--motion", motion_,
          "linear, or physical: the source is an elastic curve whose rest shape is the destination")
      ->check(CLI::IsMember({"linear", "physical"}).description(""))
      ->capture_default_str();
  dynamics::Material& material = options_.material;
  const dynamics::Material& lively = motion::lively_material;
  damping_ = {lively.mass_damping, lively.stiffness_damping};
  force_ = {0, 0};
  const CLI::Validator of_material = number_from(0, largest);
  of_physical_ = {
      command
          ->add_option("--stiffness", material.stiffness,
                       "Stiffness e_0 of the curve (physical motion)")
          ->check(of_material),
      command->add_option("--bending", material.bending, "Bending stiffness")->check(of_material),
      command->add_option("--density", material.density, "Density rho")->check(of_material),
      command
          ->add_option(
              "--damping", damping_,
              "s1,s2[,s3]: damping by mass, by stiffness, and by neither, which density 0 needs")
          ->delimiter(',')
          ->expected(2, 3)
          ->check(of_material),
      command
          ->add_option("--force", force_,
                       "Gravity gx,gy: the drawing flies on an arc to its destination")
          ->delimiter(',')
          ->expected(2)
          ->check(number_from(-largest, largest)),
      command->add_option("--until", until_,
                          "Length of the motion, in units in which the slowest mode of e_0 = rho "
                          "swings once; or settled"),
      command->add_option("--solver", options_.solver,
                          "Solver: spectral, decoupled, coupled, ...; an unknown name lists all"),
  };
  for (CLI::Option* option : of_physical_) option->capture_default_str();
}

void MotionOptions::check() const {
  if (is_physical()) return;
  for (const CLI::Option* option : of_physical_) {
    if (option->count() == 0) continue;
    throw std::invalid_argument(
        fmt::format("{} takes --motion physical, not linear", option->get_name()));
  }
}

motion::PhysicalOptions MotionOptions::physical(int frames) const {
  motion::PhysicalOptions options = options_;
  options.frames = frames;
  options.material.mass_damping = damping_[0];
  options.material.stiffness_damping = damping_[1];
  if (damping_.size() > 2) options.material.damping_density = damping_[2];
  options.force << force_[0], force_[1];
  if (until_ == "settled") return options;
  options.until = parsed_number(until_);
  if (!options.until) {
    throw std::invalid_argument(
        must_be("--until", until_, "a number of units of time, or settled"));
  }
  return options;
}

}  // namespace wavecurve::tools
