#include "verification/study/study_ground.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "verification/study/named_shapes.hpp"
#include "verification/study/study_plan.hpp"

namespace wavecurve::verification {

namespace {

/// FNV-1a, over the bits of the numbers.
class Fingerprint {
 public:
  void add(const Eigen::Ref<const Eigen::MatrixXd>& values) {
    for (const double value : values.reshaped()) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      for (int byte = 0; byte < 8; ++byte) {
        hash_ = (hash_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
      }
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

std::uint64_t fingerprint_of(const dynamics::InitialValueProblem& problem) {
  Fingerprint fingerprint;
  fingerprint.add(problem.initial_displacement);
  fingerprint.add(problem.times);
  const dynamics::CirculantEigenvalues symbols = problem.system.eigenvalues();
  for (const Eigen::VectorXd* part : {&symbols.mass, &symbols.damping, &symbols.stiffness}) {
    fingerprint.add(*part);
  }
  return fingerprint.value();
}

/// Filter banks and shapes by their names: a study has few of them, and many settings.
class Parts {
 public:
  dynamics::InitialValueProblem problem_of(const StudySetting& setting) {
    const dynamics::Material material{.mass_damping = setting.mass_damping,
                                      .stiffness_damping = setting.stiffness_damping};
    auto bank = banks_.find(setting.filter);
    if (bank == banks_.end()) {
      bank = banks_.emplace(setting.filter, io::load_filter_bank(setting.filter)).first;
    }
    const auto key = std::pair(setting.shape, setting.samples);
    auto shape = shapes_.find(key);
    if (shape == shapes_.end()) {
      shape = shapes_.emplace(key, shape_of(setting.shape, setting.samples)).first;
    }
    return released({bank->second, setting.samples, setting.levels, material}, shape->second,
                    study_times());
  }

 private:
  std::map<std::string, FilterBank<double>> banks_;
  std::map<std::pair<std::string, Eigen::Index>, Contour> shapes_;
};

}  // namespace

StudyGrounds::StudyGrounds(std::vector<std::shared_ptr<const StudySetting>> settings)
    : settings_(std::move(settings)) {
  Parts parts;
  for (const auto& setting : settings_) {
    const dynamics::InitialValueProblem problem = parts.problem_of(*setting);
    // What the transform's rounding leaves of a circle is no deformation.
    if (problem.initial_displacement.norm() <= 1e-12 * problem.rest.norm()) {
      throw std::invalid_argument("shape is the unit circle, but must differ from the rest shape");
    }
    fingerprints_.push_back(fingerprint_of(problem));
  }
}

std::shared_ptr<const StudyGround> StudyGrounds::take(std::size_t setting) {
  const std::shared_ptr<Slot> slot = slot_of(setting);
  const std::scoped_lock lock(slot->making);
  if (!slot->ground) slot->ground = made(setting);
  return slot->ground;
}

std::shared_ptr<StudyGrounds::Slot> StudyGrounds::slot_of(std::size_t setting) {
  const std::size_t kept = 2 * std::max(1u, std::thread::hardware_concurrency());
  const std::scoped_lock lock(access_);
  const auto found = std::ranges::find(slots_, setting, &decltype(slots_)::value_type::first);
  if (found != slots_.end()) {
    slots_.splice(slots_.begin(), slots_, found);
  } else {
    slots_.emplace_front(setting, std::make_shared<Slot>());
    if (slots_.size() > kept) slots_.pop_back();
  }
  return slots_.front().second;
}

std::shared_ptr<const StudyGround> StudyGrounds::made(std::size_t setting) const {
  dynamics::InitialValueProblem problem = Parts().problem_of(*settings_[setting]);
  if (fingerprint_of(problem) != fingerprints_[setting]) {
    throw std::runtime_error(fmt::format("filter {} or shape {} has changed during the run",
                                         settings_[setting]->filter, settings_[setting]->shape));
  }
  dynamics::Trajectory exact = dynamics::solve_spectral(problem);
  return std::make_shared<const StudyGround>(StudyGround{std::move(problem), std::move(exact)});
}

}  // namespace wavecurve::verification
