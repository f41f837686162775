#include "wavecurve/io/tracks/gait_parameters_json.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"

namespace wavecurve::io {

namespace {

using Eigen::Index;

constexpr const char* parameters_format = "wavecurve-gait";
constexpr int parameters_version = 1;

// Writing: by hand, since {fmt} gives the shortest decimals and the numbers stay on few lines.

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

template <class Values>
std::string list_text(const Values& values) {
  std::vector<std::string> texts;
  for (Index i = 0; i < values.size(); ++i) texts.push_back(number_text(values[i]));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string span_text(const gait::PathSpan& span) {
  std::vector<std::string> rows;
  for (Index i = 0; i < span.motion.parameters.rows(); ++i) {
    rows.push_back(list_text(span.motion.parameters.row(i)));
  }
  return fmt::format(
      "{{\"phase\": {}, \"share\": {}, \"model\": \"{}\", \"begin\": {}, \"end\": {},\n"
      "       \"x\": {},\n       \"y\": {},\n       \"parameters\": [{}]}}",
      quoted(span.phase), span.share, gait::model_name(span.motion.model), span.motion.begin,
      span.motion.end, list_text(span.start.col(0)), list_text(span.start.col(1)),
      fmt::join(rows, ",\n        "));
}

std::string path_text(const gait::LimbPath& path) {
  std::vector<std::string> spans;
  for (const gait::PathSpan& span : path.spans) spans.push_back(span_text(span));
  return fmt::format("    {{\"limb\": {}, \"foot\": {}, \"offset\": {}, \"phases\": [\n      {}]}}",
                     quoted(path.limb), path.foot, path.offset, fmt::join(spans, ",\n      "));
}

std::string paths_text(const std::vector<gait::LimbPath>& paths) {
  std::vector<std::string> texts;
  for (const gait::LimbPath& path : paths) texts.push_back(path_text(path));
  return fmt::format("{}", fmt::join(texts, ",\n"));
}

std::string gammas_text(const gait::PhaseGammas& gammas) {
  return fmt::format(
      "    {{\"limb\": {}, \"phase\": {},\n     \"gamma\": {},\n     \"standard_error\": {},\n"
      "     \"limb_gamma\": {}, \"limb_standard_error\": {},\n"
      "     \"level_gamma\": {}, \"level_standard_error\": {}}}",
      quoted(gammas.limb), quoted(gammas.phase), list_text(gammas.gamma),
      list_text(gammas.standard_error), number_text(gammas.limb_gamma),
      number_text(gammas.limb_standard_error), list_text(gammas.level_gamma),
      list_text(gammas.level_standard_error));
}

std::string quality_text(const gait::FitQuality& quality) {
  return fmt::format(
      "    {{\"limb\": {}, \"phase\": {}, \"model\": \"{}\", \"residual_share_of_stride\": {}, "
      "\"cross_validated\": {}, \"foot_share_of_excursion\": {}, \"cycles\": {}}}",
      quoted(quality.limb), quoted(quality.phase), gait::model_name(quality.model),
      number_text(quality.residual_share_of_stride), number_text(quality.cross_validated),
      number_text(quality.foot_share_of_excursion), quality.cycles);
}

template <class Items, class Text>
std::string json_lines(const Items& items, Text text) {
  std::vector<std::string> texts;
  for (const auto& item : items) texts.push_back(text(item));
  return fmt::format("{}", fmt::join(texts, ",\n"));
}

// Reading.

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A finite number, or null, which stands for none.
double some_number(const JsonPlace& place) { return place.is_null() ? none : place.number(); }

/// Finite numbers, or null where that is allowed; any number of them if none is asked for.
Eigen::VectorXd list(const JsonPlace& place, std::optional<Index> size, bool null_allowed) {
  const auto elements =
      place.elements(size ? std::optional(static_cast<std::size_t>(*size)) : std::nullopt);
  Eigen::VectorXd result(static_cast<Index>(elements.size()));
  for (Index i = 0; i < result.size(); ++i) {
    const JsonPlace& element = elements[static_cast<std::size_t>(i)];
    result[i] = null_allowed ? some_number(element) : element.number();
  }
  return result;
}

gait::GaitModel model_of(const JsonPlace& place) {
  return gait::find_gait_model(place.at("model").text());
}

gait::PhaseMotion motion_of(const JsonPlace& place, Index coefficients) {
  gait::PhaseMotion motion{
      model_of(place), {}, place.at("begin").number(), place.at("end").number()};
  const auto rows = place.at("parameters").elements();
  const auto size = static_cast<Index>(rows.size());
  if (!gait::has_rows(motion.model, size)) {
    throw std::invalid_argument(fmt::format("the model {} has {} rows of parameters",
                                            gait::model_name(motion.model), size));
  }
  motion.parameters.resize(size, coefficients);
  const bool null_allowed =
      motion.model == gait::GaitModel::quadratic || motion.model == gait::GaitModel::oscillator;
  for (Index i = 0; i < size; ++i) {
    motion.parameters.row(i) =
        list(rows[static_cast<std::size_t>(i)], coefficients, null_allowed).transpose();
  }
  if (motion.model == gait::GaitModel::oscillator && (motion.parameters.array() < 0).any()) {
    throw std::invalid_argument("the constants of an oscillator must be at least 0");
  }
  return motion;
}

gait::LimbPath path_of(const JsonPlace& place, Index scale, std::size_t phases) {
  gait::LimbPath path{place.at("limb").text(),
                      place.at("foot").whole_number(0, static_cast<int>(scale - 1)),
                      place.at("offset").number(),
                      {}};
  try {
    double sum = 0;
    for (const JsonPlace& span : place.at("phases").elements(phases)) {
      gait::PathSpan part{span.at("phase").text(), span.at("share").number(), Contour(scale, 2),
                          motion_of(span, 2 * scale)};
      part.start.col(0) = list(span.at("x"), scale, false);
      part.start.col(1) = list(span.at("y"), scale, false);
      if (!(part.share > 0 && part.share <= 1)) {
        throw std::invalid_argument(
            must_be("the share of phase " + part.phase, part.share, "above 0 and at most 1"));
      }
      sum += part.share;
      path.spans.push_back(std::move(part));
    }
    // Shares are rounded, each by half a unit at most.
    if (std::abs(sum - 1) > 1e-9) {
      throw std::invalid_argument(must_be("the sum of the shares", sum, "1"));
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("limb {}: {}", path.limb, error.what()));
  }
  return path;
}

gait::PhaseGammas gammas_of(const JsonPlace& place, Index coefficients) {
  return {place.at("limb").text(),
          place.at("phase").text(),
          list(place.at("gamma"), coefficients, true),
          list(place.at("standard_error"), coefficients, true),
          some_number(place.at("limb_gamma")),
          some_number(place.at("limb_standard_error")),
          list(place.at("level_gamma"), std::nullopt, true),
          list(place.at("level_standard_error"), std::nullopt, true)};
}

gait::FitQuality quality_of(const JsonPlace& place) {
  return {place.at("limb").text(),
          place.at("phase").text(),
          model_of(place),
          place.at("residual_share_of_stride").number(),
          place.at("cross_validated").number(),
          place.at("foot_share_of_excursion").number(),
          place.at("cycles").whole_number(0, std::numeric_limits<int>::max())};
}

gait::GaitParameters parameters_of(const JsonPlace& place) {
  check_kind(place, parameters_format, parameters_version);
  constexpr std::size_t stance_and_swing = 2, four_subcycles = 4;
  gait::GaitParameters parameters;
  parameters.period = place.at("period").number();
  parameters.facing = place.at("facing").number();
  parameters.stride = place.at("stride").number();
  if (!(parameters.period > 0) || std::abs(parameters.facing) != 1) {
    throw std::invalid_argument(
        fmt::format("period is {} and facing {}, but must be above 0, and 1 or -1",
                    parameters.period, parameters.facing));
  }
  parameters.filter = place.at("filter").text();
  const int samples = place.at("samples").whole_number(0, most_samples);
  parameters.samples = samples;
  parameters.scale = place.at("scale").whole_number(0, samples);
  check_samples(parameters.samples);
  check_samples(parameters.scale);
  for (const JsonPlace& limb : place.at("limbs").elements()) {
    parameters.limbs.push_back(path_of(limb, parameters.scale, stance_and_swing));
  }
  for (const JsonPlace& limb : place.at("subcycles").elements()) {
    parameters.subcycles.push_back(path_of(limb, parameters.scale, four_subcycles));
  }
  for (const JsonPlace& gammas : place.at("gammas").elements()) {
    parameters.gammas.push_back(gammas_of(gammas, 2 * parameters.scale));
  }
  for (const JsonPlace& quality : place.at("quality").elements()) {
    parameters.quality.push_back(quality_of(quality));
  }
  return parameters;
}

}  // namespace

std::string gait_parameters_json(const gait::GaitParameters& parameters) {
  return fmt::format(
      R"({{
  "format": "{}",
  "version": {},
  "period": {},
  "facing": {},
  "stride": {},
  "filter": {},
  "samples": {},
  "scale": {},
  "limbs": [
{}
  ],
  "subcycles": [
{}
  ],
  "gammas": [
{}
  ],
  "quality": [
{}
  ]
}}
)",
      parameters_format, parameters_version, parameters.period, parameters.facing,
      parameters.stride, quoted(parameters.filter), parameters.samples, parameters.scale,
      paths_text(parameters.limbs), paths_text(parameters.subcycles),
      json_lines(parameters.gammas, gammas_text), json_lines(parameters.quality, quality_text));
}

gait::GaitParameters read_gait_parameters(const std::filesystem::path& path) {
  const auto document = read_json(path);
  try {
    return parameters_of(JsonPlace(document));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

}  // namespace wavecurve::io
