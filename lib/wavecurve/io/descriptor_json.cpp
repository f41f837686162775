#include "wavecurve/io/descriptor_json.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve::io {

namespace {

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

std::optional<Colour> colour_of(const JsonPlace& place) {
  if (place.is_null()) return std::nullopt;
  if (!place.value().is_array()) place.refuse("null or [red, green, blue]");
  const auto parts = place.elements(3);
  return Colour{parts[0].number(0, 1), parts[1].number(0, 1), parts[2].number(0, 1)};
}

Paint paint_of(const JsonPlace& place) {
  Paint paint;
  paint.fill = colour_of(place.at("fill"));
  paint.stroke = colour_of(place.at("stroke"));
  paint.fill_opacity = place.at("fill_opacity").number(0, 1);
  paint.stroke_opacity = place.at("stroke_opacity").number(0, 1);
  paint.stroke_width = place.at("stroke_width").number();
  const bool evenodd = place.at("fill_rule").one_of({"nonzero", "evenodd"}) == "evenodd";
  paint.fill_rule = evenodd ? FillRule::evenodd : FillRule::nonzero;
  return paint;
}

ContourDescriptor contour_of(const JsonPlace& place, int samples) {
  ContourDescriptor contour;
  contour.closed = place.at("closed").boolean();
  contour.length = place.at("length").number();
  contour.coefficients.resize(samples, 2);
  for (int column : {0, 1}) {
    const auto values =
        place.at(column == 0 ? "x" : "y").elements(static_cast<std::size_t>(samples));
    for (Eigen::Index i = 0; i < samples; ++i) {
      contour.coefficients(i, column) = values[static_cast<std::size_t>(i)].number();
    }
  }
  return contour;
}

LayerDescriptor layer_of(const JsonPlace& place, int samples) {
  LayerDescriptor layer{place.at("id").text(), paint_of(place.at("paint")), {}};
  const auto contours = place.at("contours").elements();
  if (contours.empty()) place.at("contours").refuse("a list of at least one contour");
  for (const JsonPlace& contour : contours) layer.contours.push_back(contour_of(contour, samples));
  return layer;
}

ViewBox view_box_of(const JsonPlace& place) {
  const auto parts = place.elements(4);
  return {parts[0].number(), parts[1].number(), parts[2].number(), parts[3].number()};
}

Descriptor descriptor_of(const JsonPlace& place) {
  check_kind(place, descriptor_format, descriptor_version);
  Descriptor descriptor;
  DescriptorOptions& options = descriptor.options;
  descriptor.filter = place.at("filter").text();
  options.samples = place.at("samples").whole_number(0, most_samples);
  options.levels = place.at("levels").whole_number(0, most_samples);
  check_samples(options.samples);
  multiscale_bands(options.samples, options.levels);
  const bool interpolate = place.at("mode").one_of({"samples", "interpolate"}) == "interpolate";
  options.mode = interpolate ? SampleMode::interpolate : SampleMode::samples;
  const bool kept = place.at("corners").one_of({"ignored", "kept"}) == "kept";
  options.corners = kept ? Corners::kept : Corners::ignored;
  descriptor.view_box = view_box_of(place.at("view_box"));
  const auto layers = place.at("layers").elements();
  if (layers.empty()) place.at("layers").refuse("a list of at least one layer");
  for (const JsonPlace& layer : layers) {
    descriptor.layers.push_back(layer_of(layer, static_cast<int>(options.samples)));
  }
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
  const auto document = read_json(path);
  try {
    return descriptor_of(JsonPlace(document));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.string() + ": " + error.what());
  }
}

}  // namespace wavecurve::io
