#include "wavecurve/io/tracks/gait_parameters_json.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/files/detail/json_values.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::io {

namespace {

using Eigen::Index;
using nlohmann::json;

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

double number(const json& object, const char* key) { return number_in(object.at(key), key); }

/// Finite numbers, or null where that is allowed; any number of them if none is asked for.
Eigen::VectorXd list(const json& values, const char* what, Index size, bool null_allowed) {
  if (!values.is_array() || (size >= 0 && static_cast<Index>(values.size()) != size)) {
    throw std::invalid_argument(fmt::format("{} must be a list{}", what,
                                            size < 0 ? "" : fmt::format(" of {} numbers", size)));
  }
  Eigen::VectorXd result(static_cast<Index>(values.size()));
  for (Index i = 0; i < result.size(); ++i) {
    const json& value = values[static_cast<std::size_t>(i)];
    result[i] = value.is_number() ? value.get<double>() : none;
    if (!std::isfinite(result[i]) && !(null_allowed && value.is_null())) {
      throw std::invalid_argument(fmt::format("{} holds {}, but must hold finite numbers{}", what,
                                              value.dump(), null_allowed ? " or null" : ""));
    }
  }
  return result;
}

gait::GaitModel model_of(const json& object) {
  return gait::find_gait_model(object.at("model").get<std::string>());
}

gait::PhaseMotion motion_of(const json& object, Index coefficients) {
  gait::PhaseMotion motion{model_of(object), {}, number(object, "begin"), number(object, "end")};
  const json& rows = object.at("parameters");
  const auto size = static_cast<Index>(rows.size());
  if (!rows.is_array() || !gait::has_rows(motion.model, size)) {
    throw std::invalid_argument(fmt::format("the model {} has {} rows of parameters",
                                            gait::model_name(motion.model), size));
  }
  motion.parameters.resize(size, coefficients);
  const bool null_allowed =
      motion.model == gait::GaitModel::quadratic || motion.model == gait::GaitModel::oscillator;
  for (Index i = 0; i < size; ++i) {
    motion.parameters.row(i) =
        list(rows[static_cast<std::size_t>(i)], "a row of parameters", coefficients, null_allowed)
            .transpose();
  }
  if (motion.model == gait::GaitModel::oscillator && (motion.parameters.array() < 0).any()) {
    throw std::invalid_argument("the constants of an oscillator must be at least 0");
  }
  return motion;
}

gait::LimbPath path_of(const json& object, Index scale) {
  gait::LimbPath path{object.at("limb").get<std::string>(),
                      whole_number(object.at("foot"), "foot", 0, scale - 1),
                      number(object, "offset"),
                      {}};
  try {
    double sum = 0;
    for (const json& span : object.at("phases")) {
      gait::PathSpan part{span.at("phase").get<std::string>(), number(span, "share"),
                          Contour(scale, 2), motion_of(span, 2 * scale)};
      part.start.col(0) = list(span.at("x"), "x", scale, false);
      part.start.col(1) = list(span.at("y"), "y", scale, false);
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

gait::PhaseGammas gammas_of(const json& object, Index coefficients) {
  const auto some = [&](const char* key) {
    return object.at(key).is_null() ? none : number(object, key);
  };
  return {object.at("limb").get<std::string>(),
          object.at("phase").get<std::string>(),
          list(object.at("gamma"), "gamma", coefficients, true),
          list(object.at("standard_error"), "standard_error", coefficients, true),
          some("limb_gamma"),
          some("limb_standard_error"),
          list(object.at("level_gamma"), "level_gamma", -1, true),
          list(object.at("level_standard_error"), "level_standard_error", -1, true)};
}

gait::FitQuality quality_of(const json& object) {
  return {object.at("limb").get<std::string>(),
          object.at("phase").get<std::string>(),
          model_of(object),
          number(object, "residual_share_of_stride"),
          number(object, "cross_validated"),
          number(object, "foot_share_of_excursion"),
          static_cast<int>(
              whole_number(object.at("cycles"), "cycles", 0, std::numeric_limits<int>::max()))};
}

gait::GaitParameters parameters_of(const json& document) {
  check_kind(document, parameters_format, parameters_version);
  gait::GaitParameters parameters;
  parameters.period = number(document, "period");
  parameters.facing = number(document, "facing");
  parameters.stride = number(document, "stride");
  if (!(parameters.period > 0) || std::abs(parameters.facing) != 1) {
    throw std::invalid_argument(
        fmt::format("period is {} and facing {}, but must be above 0, and 1 or -1",
                    parameters.period, parameters.facing));
  }
  parameters.filter = document.at("filter").get<std::string>();
  parameters.samples = whole_number(document.at("samples"), "samples", 0, most_samples);
  parameters.scale = whole_number(document.at("scale"), "scale", 0, parameters.samples);
  check_samples(parameters.samples);
  check_samples(parameters.scale);
  for (const json& limb : document.at("limbs")) {
    parameters.limbs.push_back(path_of(limb, parameters.scale));
    if (parameters.limbs.back().spans.size() != 2) {
      throw std::invalid_argument(
          fmt::format("limb {} must have two phases, stance and swing", limb.at("limb").dump()));
    }
  }
  for (const json& limb : document.at("subcycles")) {
    parameters.subcycles.push_back(path_of(limb, parameters.scale));
    if (parameters.subcycles.back().spans.size() != 4) {
      throw std::invalid_argument(
          fmt::format("limb {} must have four subcycles", limb.at("limb").dump()));
    }
  }
  for (const json& gammas : document.at("gammas")) {
    parameters.gammas.push_back(gammas_of(gammas, 2 * parameters.scale));
  }
  for (const json& quality : document.at("quality")) {
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
  const std::string text = read_file(path);
  try {
    return parameters_of(parse_json(text));
  } catch (const json::exception& error) {
    constexpr std::size_t shown = 120;
    throw std::invalid_argument(path.string() + ": not the parameters of a gait: " +
                                std::string(error.what()).substr(0, shown));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

}  // namespace wavecurve::io
