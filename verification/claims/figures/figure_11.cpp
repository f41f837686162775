// Figure 11 shows how the parameters gamma are fitted to the positions of control points in the
// subcycles A and B. The video is lost; the walk of docs/examples/dog-walk.csv stands in for it.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/motion/gait/model/fit_models.hpp"

#include "verification/stand_ins/example_gait.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::figure_11 {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A coordinate of a control point of the left forelimb, the first limb of the record.
struct Coordinate {
  std::string name;
  Index point = 0;
  Index column = 0;  ///< 0: x, 1: y
};

constexpr int grid = 40;
const std::vector<gait::GaitModel> curves{gait::GaitModel::linear, gait::GaitModel::quadratic,
                                          gait::GaitModel::cubic, gait::GaitModel::sextic,
                                          gait::GaitModel::oscillator};

/// The runs of subcycle A and of B of the left forelimb, in all cycles of the record.
std::vector<gait::PhaseData> subcycles() {
  const gait::LimbTracks& walk = example_walk();
  const double period = example_gait().cycle.period, end = walk.times.tail(1).value();
  const auto [first, second] = example_key_frames();
  std::vector<gait::PhaseData> data{{"A", {}, 0, 1}, {"B", {}, 0, 1}};
  for (double shift = 0; first + period / 2 + shift <= end; shift += period) {
    const double times[] = {first + shift, second + shift, first + period / 2 + shift};
    for (std::size_t i = 0; i < 2; ++i) {
      data[i].runs.push_back(gait::phase_run(walk.times, walk.limbs[0], times[i], times[i + 1]));
    }
  }
  return data;
}

/// (q - q_2) / (q_1 - q_2) of a coefficient: 1 at key frame 1, 0 at 2; publication, section 4.2.
double share(double q, const gait::PhaseRun& run, Index coefficient) {
  return (q - run.to[coefficient]) / (run.from[coefficient] - run.to[coefficient]);
}

Contour contour_of(const Eigen::RowVectorXd& row) {
  return Eigen::Map<const Contour>(row.data(), row.size() / 2, 2);
}

gait::ModelFit fitted(gait::GaitModel model, const std::vector<gait::PhaseData>& data,
                      std::size_t subcycle) {
  gait::ModelSetting setting;
  setting.bank = find_filter_bank<double>("bspline4.4");
  setting.least_movement = 0.01 * example_gait().cycle.limbs[0].excursion;
  return gait::fit_model(model, data, subcycle, setting);
}

std::string cell(double value) { return fmt::format("{:.4f}", value); }

void append_samples(const std::vector<gait::PhaseData>& data, Index coefficient, Table& table) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (const gait::PhaseRun& run : data[i].runs) {
      for (Index j = 0; j < run.tau.size(); ++j) {
        std::vector<std::string> row(table.columns.size(), "-");
        row[0] = cell(run.tau[j]);
        row[1 + i] = cell(share(run.points(j, coefficient), run, coefficient));
        table.rows.push_back(row);
      }
    }
  }
}

void append_curves(const std::vector<gait::PhaseData>& data, const Coordinate& coordinate,
                   Index coefficient, Table& table) {
  std::vector<gait::PhaseMotion> motions;
  for (const gait::GaitModel model : curves) {
    for (std::size_t i = 0; i < 2; ++i) motions.push_back(fitted(model, data, i).motion);
  }
  for (int n = 0; n <= grid; ++n) {
    const double tau = static_cast<double>(n) / grid;
    std::vector<std::string> row{cell(tau), "-", "-"};
    for (std::size_t m = 0; m < motions.size(); ++m) {
      const gait::PhaseRun& run = data[m % 2].runs[0];
      const Contour pose =
          gait::pose_between(motions[m], contour_of(run.from), contour_of(run.to), tau);
      row.push_back(cell(share(pose(coordinate.point, coordinate.column), run, coefficient)));
    }
    table.rows.push_back(row);
  }
}

Chart curves_chart(const std::vector<gait::PhaseData>& data, const Coordinate& coordinate,
                   const std::string& id) {
  const Index coefficient =
      coordinate.point + coordinate.column * example_walk().limbs[0].outlines[0].rows();
  Chart chart;
  chart.id = id;
  chart.data = {fmt::format("{}: (q \u2212 q_2) / (q_1 \u2212 q_2) by \u03c4, record and models",
                            coordinate.name),
                {"\u03c4", "record, A", "record, B"},
                {}};
  for (const gait::GaitModel model : curves) {
    for (const char* subcycle : {"A", "B"}) {
      chart.data.columns.push_back(fmt::format("{}, {}", gait::model_name(model), subcycle));
    }
  }
  append_curves(data, coordinate, coefficient, chart.data);
  append_samples(data, coefficient, chart.data);
  // The curves of A and of B of each model, in the same dashes.
  chart.script =
      "set datafile missing \"-\"\nset xlabel \"\u03c4\"\nset ylabel \"f\"\nset key width -4\n"
      "plot data using 1:2 with points pointtype 6 pointsize 1 linecolor rgb \"#1f5a96\", "
      "'' using 1:3 with points pointtype 2 pointsize 1 linecolor rgb \"#b3541e\", "
      "'' using 1:4 with lines linewidth 1 linecolor rgb \"#999999\" title \"linear\", "
      "for [i=1:4] '' using 1:(column(2*i+4)) with lines linecolor rgb \"#1f5a96\" "
      "linewidth 1.5 dashtype i title columnheader(2*i+4), "
      "for [i=1:4] '' using 1:(column(2*i+5)) with lines linecolor rgb \"#b3541e\" "
      "linewidth 1.5 dashtype i title columnheader(2*i+5)\n";
  return chart;
}

/// What each model leaves of the swing of a foot, in % of the stride.
Chart swing_chart() {
  const gait::GaitFit& gait = example_gait();
  const gait::LimbFit& limb = gait.limbs.at(0);
  const gait::PhaseData& swing = limb.phases.at(1);
  const gait::PhaseRun& run = swing.runs.at(0);
  const Index foot = gait.cycle.limbs.at(0).foot;
  Chart chart;
  chart.id = "figure-11-swing";
  chart.data = {
      "The left forefoot in its first swing: fore-aft place, record less model, in % of "
      "the stride",
      {"\u03c4"},
      {}};
  for (const gait::GaitModel model : gait::gait_models) {
    chart.data.columns.emplace_back(gait::model_name(model));
  }
  for (Index j = 0; j < run.tau.size(); ++j) {
    std::vector<std::string> row{cell(run.tau[j])};
    for (const gait::ModelFit& fit : limb.models.at(1)) {
      const Contour pose =
          gait::pose_between(fit.motion, contour_of(run.from), contour_of(run.to), run.tau[j]);
      row.push_back(
          fmt::format("{:.2f}", 100 * (run.points(j, foot) - pose(foot, 0)) / gait.cycle.stride));
    }
    chart.data.rows.push_back(row);
  }
  chart.script = fmt::format(
      "set xlabel \"\u03c4\"\nset ylabel \"record less model, % of the stride\"\n"
      "plot for [i=2:{}] data using 1:i with linespoints linewidth 1.5 pointtype i\n",
      gait::gait_models.size() + 1);
  return chart;
}

std::string with_error(double value, double error) {
  return std::isnan(value) ? "-" : fmt::format("{:.3f} \u00b1 {:.2g}", value, error);
}

Table gamma_table(const std::vector<Coordinate>& coordinates) {
  Table table{
      "The publication's \u03b3, with standard errors, of the subcycles of the left limbs; "
      "a coefficient that moves by less than 1 % of the excursion of the foot has none",
      {"limb", "subcycle"},
      {}};
  for (const Coordinate& one : coordinates) table.columns.push_back(one.name);
  table.columns.insert(table.columns.end(), {"one for the limb", "coefficients with a \u03b3"});
  const Index points = example_walk().limbs[0].outlines[0].rows();
  for (const gait::PhaseGammas& one : example_gait().parameters.gammas) {
    if (one.phase.size() != 1) continue;
    std::vector<std::string> row{one.limb, one.phase};
    for (const Coordinate& coordinate : coordinates) {
      const Index i = coordinate.point + coordinate.column * points;
      row.push_back(with_error(one.gamma[i], one.standard_error[i]));
    }
    row.push_back(with_error(one.limb_gamma, one.limb_standard_error));
    row.push_back(fmt::format("{} of {}", one.gamma.size() - one.gamma.array().isNaN().count(),
                              one.gamma.size()));
    table.rows.push_back(row);
  }
  return table;
}

/// The largest residual of a model's swing over all limbs, as a share of the stride.
double largest_residual(gait::GaitModel model) {
  double largest = 0;
  for (const gait::FitQuality& one : example_gait().parameters.quality) {
    if (one.model == model && one.phase == "swing") {
      largest = std::max(largest, one.residual_share_of_stride);
    }
  }
  return largest;
}

Outcome evaluate() {
  const Index foot = example_gait().cycle.limbs.at(0).foot;
  // The first point of an outline is the tip at the scapula; half of the way from there to the toe
  // is the elbow.
  const std::vector<Coordinate> coordinates{
      {"forefoot, x", foot, 0}, {"forefoot, y", foot, 1}, {"elbow, x", foot / 2, 0}};
  const std::vector<gait::PhaseData> data = subcycles();
  Outcome outcome;
  outcome.verdict = ClaimVerdict::stand_in;
  const auto residual = [](const std::string& name, gait::GaitModel model) {
    return to_digits("largest residual of a swing, " + name, 100 * largest_residual(model), 2, "%");
  };
  outcome.finding = {
      "largest residual of a swing: quadratic {}, cubic {}, sextic {} of the stride",
      {residual("quadratic", gait::GaitModel::quadratic), residual("cubic", gait::GaitModel::cubic),
       residual("sextic", gait::GaitModel::sextic)}};
  outcome.summary =
      "The video is lost; the samples are those of docs/examples/dog-walk.csv, o in subcycle A and "
      "x "
      "in subcycle B as in the print, with the curves of several models through both key frames. A "
      "swing is slow, fast, slow: the publication's quadratic, which has one parameter and is "
      "pinned "
      "at both ends, cannot follow it; one cubic term more can.";
  outcome.evidence = {
      curves_chart(data, coordinates[0], "figure-11"),
      curves_chart(data, coordinates[2], "figure-11-elbow"), swing_chart(),
      gamma_table(coordinates),
      quality_table({"stance", "swing"}, {gait::gait_models.begin(), gait::gait_models.end()})};
  return outcome;
}

const RegisterClaim registered(
    {"figure-11", "Parameters fitted to the positions of limbs", "Section 4.2, Figure 11",
     "we find the best parameter gamma that minimizes the error squares. In the plot, 'o' is the "
     "positions of limbs in Subcycle A (the subcycle from Key frames 1 to Key frames 2) and 'x' is "
     "the positions in Subcycle B",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::figure_11
