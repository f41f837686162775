#include "tools/commands/output/gait_table.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/motion/gait/model/limb_path.hpp"
#include "wavecurve/motion/gait/walk/ground_contact.hpp"

namespace wavecurve::tools {

namespace {

std::string heading(const gait::GaitParameters& parameters) {
  const bool is_whole = parameters.scale == parameters.samples;
  return fmt::format("period {:.4g}, stride {:.4g}, looks to the {}; {} of an outline ({})\n\n",
                     parameters.period, parameters.stride, parameters.facing > 0 ? "right" : "left",
                     is_whole ? fmt::format("all {} points", parameters.samples)
                              : fmt::format("{} control points", parameters.scale),
                     printable(parameters.filter));
}

std::string footfalls(const gait::GaitParameters& parameters) {
  constexpr int columns = 50;
  std::string text = fmt::format("limb  touch-down  duty factor  on the ground, through a cycle\n");
  for (const gait::LimbPath& path : parameters.limbs) {
    const gait::CyclePart contact = gait::ground_contact(path, parameters.facing);
    std::string bar;
    for (int i = 0; i < columns; ++i) {
      bar += contact.since((i + 0.5) / columns) < contact.length ? '#' : '.';
    }
    text += fmt::format("{:4}  {:10.2f}  {:11.2f}  {}\n", path.limb, contact.begin, contact.length,
                        bar);
  }
  return text + '\n';
}

/// The foot's fore-aft way through the cycle, of a pair of limbs: L, R, and B where both are.
std::string foot_ways(const gait::GaitParameters& parameters, char pair) {
  constexpr int rows = 9, columns = 50;
  std::vector<gait::LimbPath> feet;
  for (const gait::LimbPath& path : parameters.limbs) {
    if (path.limb.size() == 2 && path.limb[1] == pair) {
      feet.push_back(gait::path_of_point(path, path.foot));
    }
  }
  if (feet.empty()) return "";
  const auto forwards = [&](const gait::LimbPath& foot, int column) {
    return parameters.facing * pose_at(foot, (column + 0.5) / columns)(0, 0);
  };
  double most = forwards(feet[0], 0), least = most;
  for (const gait::LimbPath& foot : feet) {
    for (int i = 0; i < columns; ++i) {
      most = std::max(most, forwards(foot, i));
      least = std::min(least, forwards(foot, i));
    }
  }
  std::vector<std::string> lines(rows, std::string(columns, ' '));
  for (const gait::LimbPath& foot : feet) {
    for (int i = 0; i < columns; ++i) {
      const double share = (most - forwards(foot, i)) / (most - least);
      const auto row = static_cast<std::size_t>(std::lround(share * (rows - 1)));
      char& mark = lines[row][static_cast<std::size_t>(i)];
      mark = mark == ' ' ? foot.limb[0] : 'B';
    }
  }
  std::string text =
      fmt::format("{} feet, forwards up, by {:.4g}\n", pair == 'F' ? "fore" : "hind", most - least);
  for (const std::string& line : lines) text += fmt::format("{:31}|{}|\n", "", line);
  return text + '\n';
}

/// The model that a phase of a limb is drawn by.
gait::GaitModel chosen(const gait::GaitParameters& parameters, const gait::FitQuality& quality) {
  for (const gait::LimbPath& path : parameters.limbs) {
    for (const gait::PathSpan& span : path.spans) {
      if (path.limb == quality.limb && span.phase == quality.phase) return span.motion.model;
    }
  }
  return gait::GaitModel::linear;
}

std::string residuals(const gait::GaitParameters& parameters, bool only_chosen) {
  std::string text = fmt::format(
      "residual, and cross-validated, in % of the stride{}; of the foot, in % of its excursion\n\n"
      "limb  phase   cycles  model                 residual  cross-validated   foot\n",
      only_chosen ? "" : "; * chosen");
  std::string last;
  for (const gait::FitQuality& quality : parameters.quality) {
    const bool is_chosen = chosen(parameters, quality) == quality.model;
    if (only_chosen && !is_chosen) continue;
    const std::string place = quality.limb + ' ' + quality.phase;
    const bool is_new = place != last;
    last = place;
    text += fmt::format("{:4}  {:6}  {:>6}  {:18} {}  {:8.3f}  {:15.3f}  {:5.1f}\n",
                        is_new ? quality.limb : "", is_new ? quality.phase : "",
                        is_new ? fmt::format("{}", quality.cycles) : "",
                        gait::model_name(quality.model), is_chosen && !only_chosen ? '*' : ' ',
                        100 * quality.residual_share_of_stride, 100 * quality.cross_validated,
                        100 * quality.foot_share_of_excursion);
  }
  return text;
}

std::string gammas(const gait::GaitParameters& parameters) {
  std::string text =
      "gamma of the whole limb, its standard error, and how many coefficients move enough for "
      "one\n\n"
      "limb  phase    gamma  standard error  of their own\n";
  for (const gait::PhaseGammas& phase : parameters.gammas) {
    const auto own = phase.gamma.size() - phase.gamma.array().isNaN().count();
    text += fmt::format("{:4}  {:6} {:7.3f}  {:14.3f}  {:>12}\n", phase.limb, phase.phase,
                        phase.limb_gamma, phase.limb_standard_error,
                        fmt::format("{} of {}", own, phase.gamma.size()));
  }
  return text;
}

}  // namespace

std::string gait_summary(const gait::GaitParameters& parameters) {
  return heading(parameters) + footfalls(parameters) + residuals(parameters, true);
}

std::string gait_table(const gait::GaitParameters& parameters) {
  return heading(parameters) + footfalls(parameters) + foot_ways(parameters, 'F') +
         foot_ways(parameters, 'H') + residuals(parameters, false) + '\n' + gammas(parameters);
}

}  // namespace wavecurve::tools
