#include "wavecurve/io/animations/end_paths.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"

namespace wavecurve::io {

namespace {

nlohmann::ordered_json end_json(const motion::FrameLayer& layer, bool cubic,
                                const Decimals& decimals) {
  nlohmann::ordered_json json{
      {"d", path_data(layer.contours, cubic, decimals, layer.open, Coordinates::absolute)}};
  for (const auto& [name, value] : svg_paint(layer.paint)) json[name] = value;
  return json;
}

}  // namespace

std::string end_paths(const motion::Animation& animation, const OutputOptions& options) {
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const ViewBox& box = animation.view_box;
  const Decimals decimals = Decimals::for_box(box, options.accuracy);
  nlohmann::ordered_json json{
      {"view_box", fmt::format("{} {} {} {}", decimals.text(box.x), decimals.text(box.y),
                               decimals.text(box.width), decimals.text(box.height))},
      {"layers", nlohmann::ordered_json::array()}};
  for (const std::size_t i : order_at(points.animation, 0)) {
    const motion::AnimatedLayer& layer = points.animation.layers[i];
    json["layers"].push_back(
        {{"id", layer.id},
         {"source", end_json(layer_at(layer, 0), points.cubic, decimals)},
         {"destination", end_json(layer_at(layer, animation.duration), points.cubic, decimals)}});
  }
  const auto last = order_at(animation, animation.duration);
  if (last != order_at(animation, 0)) {
    for (const std::size_t i : last) json["destination_order"].push_back(animation.layers[i].id);
  }
  return json_text(json) + "\n";
}

}  // namespace wavecurve::io
