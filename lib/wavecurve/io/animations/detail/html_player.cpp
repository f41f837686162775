#include "wavecurve/io/animations/detail/html_player.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/detail/control_points.hpp"
#include "wavecurve/io/animations/detail/player_page.hpp"
#include "wavecurve/io/drawings/detail/svg_paint.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/files/detail/xml_escaped.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::io {

namespace {

using Json = nlohmann::ordered_json;

/// x and y in turn, rounded.
Json points_json(const Contour& contour, const Decimals& decimals) {
  Json json = Json::array();
  for (Eigen::Index row = 0; row < contour.rows(); ++row) {
    json.push_back(decimals.rounded(contour(row, 0)));
    json.push_back(decimals.rounded(contour(row, 1)));
  }
  return json;
}

/// The coefficients without the details that are too small to matter: the curve of the others is nowhere
/// farther than the tolerance from the whole one.
Contour without_small_details(const motion::Morph& morph, const Contour& coefficients,
                              double tolerance) {
  const Eigen::Index coarse = coefficients.rows() >> morph.levels;
  for (double threshold = tolerance;; threshold /= 2) {
    Contour small = coefficients;
    for (Eigen::Index row = 0; row < small.rows(); ++row) {
      if (row < coarse || small.row(row).norm() > threshold) small.row(row).setZero();
    }
    const Contour moved = to_samples(morph.bank, small, morph.levels);
    if (moved.rowwise().norm().maxCoeff() <= tolerance) return coefficients - small;
  }
}

/// The points of coefficients many of which are zero: a text is a number of points that are.
Json sparse_json(const Contour& coefficients, const Decimals& decimals) {
  Json json = Json::array();
  int zeros = 0;
  const auto end_zeros = [&] {
    if (zeros > 0) json.push_back(std::to_string(zeros));
    zeros = 0;
  };
  for (Eigen::Index row = 0; row < coefficients.rows(); ++row) {
    const double x = decimals.rounded(coefficients(row, 0));
    const double y = decimals.rounded(coefficients(row, 1));
    if (x == 0 && y == 0) {
      ++zeros;
      continue;
    }
    end_zeros();
    json.push_back(x);
    json.push_back(y);
  }
  end_zeros();
  return json;
}

Json coefficients_json(const motion::Morph& morph, const Contour& coefficients,
                       const Decimals& decimals, double tolerance) {
  if (tolerance == 0) return points_json(coefficients, decimals);
  return sparse_json(without_small_details(morph, coefficients, tolerance), decimals);
}

Json colour_json(const std::optional<Colour>& colour) {
  if (!colour) return nullptr;
  const Decimals share(4);
  return {share.rounded(colour->red), share.rounded(colour->green), share.rounded(colour->blue)};
}

Json paint_json(const std::vector<motion::PaintKey>& keys) {
  Json json = Json::array();
  for (const motion::PaintKey& key : keys) {
    const Paint& paint = key.paint;
    json.push_back({{"time", key.time},
                    {"fill", colour_json(paint.fill)},
                    {"fill_opacity", paint.fill_opacity},
                    {"stroke", colour_json(paint.stroke)},
                    {"stroke_opacity", paint.stroke_opacity},
                    {"stroke_width", paint.stroke_width},
                    {"line_cap", name_of(paint.line_cap)},
                    {"line_join", name_of(paint.line_join)},
                    {"miter_limit", paint.miter_limit},
                    {"fill_rule", paint.fill_rule == FillRule::evenodd ? "evenodd" : "nonzero"}});
  }
  return json;
}

/// What a layer of a morph and one of an animation have in common.
template <class Layer>
Json layer_json(const Layer& layer) {
  return {{"id", layer.id}, {"paint", paint_json(layer.paint)}};
}

Json order_json(const std::vector<motion::OrderKey>& keys) {
  Json json = Json::array();
  for (const motion::OrderKey& key : keys) {
    json.push_back({{"time", key.time}, {"order", key.order}});
  }
  return json;
}

Json outline_json(const std::vector<motion::OutlineKey>& keys, const Decimals& decimals) {
  Json json = Json::array();
  for (const motion::OutlineKey& key : keys) {
    Json contours = Json::array();
    for (const Contour& contour : key.contours) contours.push_back(points_json(contour, decimals));
    json.push_back({{"time", key.time}, {"contours", contours}});
  }
  return json;
}

Json filter_json(const Filter<double>& filter) {
  return {{"first", filter.first_index}, {"taps", filter.taps}};
}

std::string_view detail_name(motion::Detail detail) {
  switch (detail) {
    case motion::Detail::drop:
      return "drop";
    case motion::Detail::stage:
      return "stage";
    default:
      return "blend";
  }
}

Json background_json(const OutputOptions& options) {
  if (options.background) return hex_colour(*options.background);
  return options.transparent ? Json("none") : Json(nullptr);
}

/// What every page holds.
Json page_json(const ViewBox& box, double duration, const OutputOptions& options) {
  check_at_least("frames", options.frames, 2);
  return {{"view_box", {box.x, box.y, box.width, box.height}},
          {"duration", duration},
          {"frames", options.frames},
          {"places", Decimals::for_box(box, options.accuracy).places()},
          {"background", background_json(options)},
          {"layers", Json::array()}};
}

void replace_all(std::string& text, std::string_view mark, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += by.size()) {
    text.replace(at, mark.size(), by);
  }
}

/// The page with each mark replaced by its text, in which no mark is looked for.
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string_view, std::string>>& texts) {
  std::string result;
  while (!page.empty()) {
    const auto starts = [&](const auto& mark) { return page.starts_with(mark.first); };
    const auto found = std::ranges::find_if(texts, starts);
    result += found == texts.end() ? page.substr(0, 1) : std::string_view(found->second);
    page.remove_prefix(found == texts.end() ? 1 : found->first.size());
  }
  return result;
}

std::string page(const Json& data, const OutputOptions& options) {
  std::string json = json_text(data);
  replace_all(json, "<", "\\u003c");  // no text of a drawing may end the element
  return filled(player_page, {{"{{title}}", xml_escaped(options.title)}, {"{{data}}", json}});
}

}  // namespace

std::string html_player(const motion::Animation& animation, const OutputOptions& options) {
  const AnimatedControlPoints points = control_points(animation, options.tolerance);
  const Decimals decimals = Decimals::for_box(animation.view_box, options.accuracy);
  Json data = page_json(animation.view_box, animation.duration, options);
  data["repeat"] = options.loop ? "loop" : "once";
  data["cubic"] = points.cubic;
  data["order"] = order_json(animation.order);
  for (const motion::AnimatedLayer& layer : points.animation.layers) {
    Json json = layer_json(layer);
    json["outline"] = outline_json(layer.outline, decimals);
    json["open"] = layer.open;
    data["layers"].push_back(json);
  }
  return page(data, options);
}

std::string html_player(const motion::Morph& morph, const OutputOptions& options) {
  motion::check_animation(motion::animate(morph));
  check_at_least("tolerance", options.tolerance, 0);
  // A tenth of the accuracy of points, since a point is a sum of several coefficients.
  const Decimals decimals = Decimals::for_box(morph.view_box, options.accuracy / 10);
  const auto of = [&](const Contour& coefficients) {
    return coefficients_json(morph, coefficients, decimals, options.tolerance);
  };
  Json data = page_json(morph.view_box, morph.duration, options);
  data["repeat"] = options.loop ? "bounce" : "once";
  data["cubic"] = false;
  data["order"] = order_json(morph.order);
  data["bank"] = {{"low", filter_json(morph.bank.synthesis_low)},
                  {"high", filter_json(morph.bank.synthesis_high)}};
  data["levels"] = morph.levels;
  data["detail"] = detail_name(morph.detail);
  data["stage_share"] = morph.stage_share;
  for (const motion::MorphLayer& layer : morph.layers) {
    Json json = layer_json(layer);
    json["scale"] = layer.scale;
    json["open"] = motion::open_contours(layer);
    json["contours"] = Json::array();
    for (const motion::ContourPair& pair : layer.contours) {
      json["contours"].push_back(
          {{"source", of(pair.source)}, {"destination", of(pair.destination)}});
    }
    data["layers"].push_back(json);
  }
  return page(data, options);
}

}  // namespace wavecurve::io
