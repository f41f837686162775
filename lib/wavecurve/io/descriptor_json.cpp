#include "wavecurve/io/descriptor_json.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_values.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve::io {

namespace {

using nlohmann::json;

constexpr const char* descriptor_format = "wavecurve-descriptor";
constexpr int descriptor_version = 1;

// Writing: by hand, since {fmt} gives the shortest decimals and the numbers stay on few lines.

std::string colour_text(const std::optional<Colour>& colour) {
  return colour ? fmt::format("[{}, {}, {}]", colour->red, colour->green, colour->blue) : "null";
}

std::string paint_text(const Paint& paint) {
  return fmt::format(
      R"({{"fill": {}, "fill_opacity": {}, "fill_rule": "{}",
        "stroke": {}, "stroke_opacity": {}, "stroke_width": {}}})",
      colour_text(paint.fill), paint.fill_opacity,
      paint.fill_rule == FillRule::evenodd ? "evenodd" : "nonzero", colour_text(paint.stroke),
      paint.stroke_opacity, paint.stroke_width);
}

std::string contour_text(const ContourDescriptor& contour) {
  const auto& c = contour.coefficients;
  return fmt::format("{{\"closed\": {}, \"length\": {},\n       \"x\": [{}],\n       \"y\": [{}]}}",
                     contour.closed, contour.length, fmt::join(c.col(0), ", "),
                     fmt::join(c.col(1), ", "));
}

std::string layer_text(const LayerDescriptor& layer) {
  std::vector<std::string> contours;
  for (const ContourDescriptor& contour : layer.contours) contours.push_back(contour_text(contour));
  return fmt::format("    {{\"id\": {},\n     \"paint\": {},\n     \"contours\": [\n      {}]}}",
                     quoted(layer.id), paint_text(layer.paint), fmt::join(contours, ",\n      "));
}

// Reading.

/// Whether the second of two words stands there, not the first.
bool is_second(const json& object, const char* key, const char* first, const char* second) {
  const json& value = object.at(key);
  if (value != first && value != second) {
    throw std::invalid_argument(
        fmt::format("{} is {}, but must be \"{}\" or \"{}\"", key, value.dump(), first, second));
  }
  return value == second;
}

std::optional<Colour> colour_of(const json& object, const char* key) {
  const json& value = object.at(key);
  if (value.is_null()) return std::nullopt;
  if (!value.is_array() || value.size() != 3) {
    throw std::invalid_argument(fmt::format("{} must be null or [red, green, blue]", key));
  }
  return Colour{number_in(value[0], key, 1), number_in(value[1], key, 1),
                number_in(value[2], key, 1)};
}

Paint paint_of(const json& object) {
  Paint paint;
  paint.fill = colour_of(object, "fill");
  paint.stroke = colour_of(object, "stroke");
  paint.fill_opacity = number_in(object.at("fill_opacity"), "fill_opacity", 1);
  paint.stroke_opacity = number_in(object.at("stroke_opacity"), "stroke_opacity", 1);
  paint.stroke_width = number_in(object.at("stroke_width"), "stroke_width");
  const bool evenodd = is_second(object, "fill_rule", "nonzero", "evenodd");
  paint.fill_rule = evenodd ? FillRule::evenodd : FillRule::nonzero;
  return paint;
}

ContourDescriptor contour_of(const json& object, Eigen::Index samples) {
  ContourDescriptor contour;
  contour.closed = object.at("closed").get<bool>();
  contour.length = number_in(object.at("length"), "length");
  contour.coefficients.resize(samples, 2);
  for (int column : {0, 1}) {
    const char* key = column == 0 ? "x" : "y";
    const json& values = object.at(key);
    if (!values.is_array() || static_cast<Eigen::Index>(values.size()) != samples) {
      throw std::invalid_argument(
          fmt::format("{} holds {} values, but samples is {}", key, values.size(), samples));
    }
    for (Eigen::Index i = 0; i < samples; ++i) {
      contour.coefficients(i, column) = number_in(values[static_cast<std::size_t>(i)], key);
    }
  }
  return contour;
}

LayerDescriptor layer_of(const json& object, Eigen::Index samples) try {
  LayerDescriptor layer{object.at("id").get<std::string>(), paint_of(object.at("paint")), {}};
  for (const json& contour : object.at("contours")) {
    layer.contours.push_back(contour_of(contour, samples));
  }
  if (layer.contours.empty()) throw std::invalid_argument("there is no contour");
  return layer;
} catch (const std::invalid_argument& error) {
  throw std::invalid_argument(
      fmt::format("layer {}: {}", object.at("id").get<std::string>(), error.what()));
}

ViewBox view_box_of(const json& value) {
  if (!value.is_array() || value.size() != 4) {
    throw std::invalid_argument("view_box must be [x, y, width, height]");
  }
  const auto part = [&](std::size_t i) { return number_in(value[i], "view_box"); };
  return {part(0), part(1), part(2), part(3)};
}

Descriptor descriptor_of(const json& document) {
  check_kind(document, descriptor_format, descriptor_version);
  Descriptor descriptor;
  DescriptorOptions& options = descriptor.options;
  descriptor.filter = document.at("filter").get<std::string>();
  options.samples =
      static_cast<int>(whole_number(document.at("samples"), "samples", 0, most_samples));
  options.levels = static_cast<int>(whole_number(document.at("levels"), "levels", 0, most_samples));
  check_samples(options.samples);
  multiscale_bands(options.samples, options.levels);
  const bool interpolate = is_second(document, "mode", "samples", "interpolate");
  options.mode = interpolate ? SampleMode::interpolate : SampleMode::samples;
  const bool kept = is_second(document, "corners", "ignored", "kept");
  options.corners = kept ? Corners::kept : Corners::ignored;
  descriptor.view_box = view_box_of(document.at("view_box"));
  for (const json& layer : document.at("layers")) {
    descriptor.layers.push_back(layer_of(layer, options.samples));
  }
  if (descriptor.layers.empty()) throw std::invalid_argument("there is no layer");
  return descriptor;
}

}  // namespace

std::string descriptor_json(const Descriptor& descriptor) {
  const DescriptorOptions& options = descriptor.options;
  const ViewBox& box = descriptor.view_box;
  std::vector<std::string> layers;
  for (const LayerDescriptor& layer : descriptor.layers) layers.push_back(layer_text(layer));
  return fmt::format(
      R"({{
  "format": "{}",
  "version": {},
  "filter": {},
  "samples": {},
  "levels": {},
  "mode": "{}",
  "corners": "{}",
  "view_box": [{}, {}, {}, {}],
  "layers": [
{}
  ]
}}
)",
      descriptor_format, descriptor_version, quoted(descriptor.filter), options.samples,
      options.levels, options.mode == SampleMode::interpolate ? "interpolate" : "samples",
      options.corners == Corners::kept ? "kept" : "ignored", box.x, box.y, box.width, box.height,
      fmt::join(layers, ",\n"));
}

Descriptor read_descriptor(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  try {
    return descriptor_of(parse_json(text));
  } catch (const json::exception& error) {
    constexpr std::size_t shown = 120;
    throw std::invalid_argument(
        path.string() + ": not a descriptor: " + std::string(error.what()).substr(0, shown));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

}  // namespace wavecurve::io
