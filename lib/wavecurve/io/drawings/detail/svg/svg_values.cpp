// The one file that compiles the grammars of SVG++: they take long.
#include "wavecurve/io/drawings/detail/svg/svg_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <svgpp/factory/integer_color.hpp>
#include <svgpp/parser/external_function/parse_color_impl.hpp>
#include <svgpp/parser/grammar/path_data.hpp>
#include <svgpp/parser/grammar/transform.hpp>

#include <fmt/format.h>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/io/drawings/detail/svg/arc.hpp"

namespace wavecurve::io {

namespace {

using Eigen::Vector2d;
using svgpp::tag::coordinate::absolute;
using svgpp::tag::coordinate::relative;

/// Receives the commands of path data as they are written.
class PathEvents {
 public:
  explicit PathEvents(PathBuilder& path) : path_(path) {}

  template <typename Mode>
  void path_move_to(double x, double y, Mode) {
    path_.move_to(origin(Mode{}) + Vector2d(x, y));
    forget_control();
  }
  template <typename Mode>
  void path_line_to(double x, double y, Mode) {
    path_.line_to(origin(Mode{}) + Vector2d(x, y));
    forget_control();
  }
  template <typename Mode>
  void path_line_to_ortho(double value, bool horizontal, Mode) {
    Vector2d to = path_.current();
    const int axis = horizontal ? 0 : 1;
    to[axis] = origin(Mode{})[axis] + value;
    path_.line_to(to);
    forget_control();
  }
  template <typename Mode>
  void path_cubic_bezier_to(double x1, double y1, double x2, double y2, double x, double y, Mode) {
    const Vector2d from = origin(Mode{});
    cubic_to(from + Vector2d(x1, y1), from + Vector2d(x2, y2), from + Vector2d(x, y));
  }
  template <typename Mode>
  void path_cubic_bezier_to(double x2, double y2, double x, double y, Mode) {
    const Vector2d from = origin(Mode{});
    cubic_to(reflected(3), from + Vector2d(x2, y2), from + Vector2d(x, y));
  }
  template <typename Mode>
  void path_quadratic_bezier_to(double x1, double y1, double x, double y, Mode) {
    const Vector2d from = origin(Mode{});
    quadratic_to(from + Vector2d(x1, y1), from + Vector2d(x, y));
  }
  template <typename Mode>
  void path_quadratic_bezier_to(double x, double y, Mode) {
    const Vector2d from = origin(Mode{});
    quadratic_to(reflected(2), from + Vector2d(x, y));
  }
  template <typename Mode>
  void path_elliptical_arc_to(double rx, double ry, double rotation, bool large, bool clockwise,
                              double x, double y, Mode) {
    append_endpoint_arc(path_, Vector2d(rx, ry), rotation, large, clockwise,
                        origin(Mode{}) + Vector2d(x, y));
    forget_control();
  }
  void path_close_subpath() {
    path_.close();
    forget_control();
  }
  void path_exit() {}

 private:
  Vector2d origin(absolute) const { return Vector2d::Zero(); }
  Vector2d origin(relative) const { return path_.current(); }

  void cubic_to(const Vector2d& first, const Vector2d& second, const Vector2d& to) {
    path_.cubic_to(first, second, to);
    last_control_ = second;
    last_degree_ = 3;
  }
  void quadratic_to(const Vector2d& control, const Vector2d& to) {
    path_.quadratic_to(control, to);
    last_control_ = control;
    last_degree_ = 2;
  }
  void forget_control() { last_degree_ = 0; }
  /// The first control point of the smooth commands S and T.
  Vector2d reflected(int degree) const {
    if (last_degree_ != degree) return path_.current();
    return 2 * path_.current() - last_control_;
  }

  PathBuilder& path_;
  Vector2d last_control_ = Vector2d::Zero();
  int last_degree_ = 0;
};

using PathGrammar = svgpp::path_data_grammar<const char*, PathEvents, double>;

/// Multiplies the transformations of a list.
struct TransformEvents {
  Eigen::Affine2d product = Eigen::Affine2d::Identity();

  static double radians(double degrees) { return degrees * std::numbers::pi / 180; }
  void transform_matrix(const boost::array<double, 6>& m) {
    Eigen::Affine2d factor = Eigen::Affine2d::Identity();
    factor.matrix().topRows<2>() << m[0], m[2], m[4], m[1], m[3], m[5];
    product = product * factor;
  }
  void transform_translate(double x, double y) { product.translate(Vector2d(x, y)); }
  void transform_translate(double x) { transform_translate(x, 0); }
  void transform_scale(double x, double y) { product.scale(Vector2d(x, y)); }
  void transform_scale(double factor) { transform_scale(factor, factor); }
  void transform_rotate(double degrees) { product.rotate(radians(degrees)); }
  void transform_rotate(double degrees, double x, double y) {
    transform_translate(x, y);
    transform_rotate(degrees);
    transform_translate(-x, -y);
  }
  void transform_skew_x(double degrees) {
    transform_matrix({{1, 0, tangent(radians(degrees)), 1, 0, 0}});
  }
  void transform_skew_y(double degrees) {
    transform_matrix({{1, tangent(radians(degrees)), 0, 1, 0, 0}});
  }
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

[[noreturn]] void refuse_text(std::string_view text, std::size_t position,
                              std::string_view defect) {
  constexpr std::size_t shown = 16;
  throw std::invalid_argument(fmt::format("{} after {} characters, at '{}'", defect, position,
                                          text.substr(position, shown)));
}

/// The parser of numbers relies on exponents and fractions of sensible lengths. Where a number is
/// too long, its begin, and what is wrong with it.
struct LongNumber {
  std::size_t begin;
  std::string defect;
};

std::optional<LongNumber> find_long_number(std::string_view text) {
  constexpr std::size_t most_digits = 100, most_exponent_digits = 4;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i])) continue;
    const std::size_t begin = i;
    while (i < text.size() && is_digit(text[i])) ++i;
    const std::size_t sign =
        begin > 0 && (text[begin - 1] == '-' || text[begin - 1] == '+') ? 1 : 0;
    const bool exponent =
        begin > sign && (text[begin - sign - 1] == 'e' || text[begin - sign - 1] == 'E');
    const std::size_t most = exponent ? most_exponent_digits : most_digits;
    if (i - begin <= most) continue;
    const std::size_t before = text.substr(0, begin).find_last_not_of("0123456789.eE+-");
    return LongNumber{before == std::string_view::npos ? 0 : before + 1,
                      fmt::format("more than {} digits in a row", most)};
  }
  return std::nullopt;
}

/// Whatever comes before the defect has been told to the events. The first characters, `prefix` of
/// them, are ours and not counted.
template <typename Grammar, typename Events>
void parse(std::string_view text, Events& events, std::string_view expected,
           std::size_t prefix = 0) {
  const auto too_long = find_long_number(text);
  const std::string_view sound = text.substr(0, too_long ? too_long->begin : text.size());
  static const Grammar grammar;
  const char* position = sound.data();
  const char* const end = sound.data() + sound.size();
  namespace qi = boost::spirit::qi;
  const bool parsed = qi::phrase_parse(position, end, grammar(boost::phoenix::ref(events)),
                                       typename Grammar::skipper_type());
  const auto reached = static_cast<std::size_t>(position - sound.data());
  if (too_long) {
    refuse_text(text.substr(prefix), std::max(too_long->begin, prefix) - prefix, too_long->defect);
  }
  if (!parsed || position != end) {
    refuse_text(text.substr(prefix), std::max(reached, prefix) - prefix,
                fmt::format("no {}", expected));
  }
}

/// The length of the number at the begin of a text, without its sign.
std::size_t length_of_number(std::string_view text) {
  std::size_t i = 0;
  const auto skip_digits = [&] {
    while (i < text.size() && is_digit(text[i])) ++i;
  };
  skip_digits();
  if (i < text.size() && text[i] == '.') ++i;
  skip_digits();
  if (i == 0 || i >= text.size() || (text[i] != 'e' && text[i] != 'E')) return i;
  const std::size_t sign =
      i + 1 < text.size() && (text[i + 1] == '-' || text[i + 1] == '+') ? 1 : 0;
  if (i + 1 + sign >= text.size() || !is_digit(text[i + 1 + sign])) return i;
  i += 1 + sign;
  skip_digits();
  return i;
}

/// Path data whose arcs have lost the signs of their radii, which count for nothing (SVG 2, 9.5.1).
std::string with_positive_radii(std::string_view text) {
  std::string result(text);
  bool is_arc = false;
  int number = 0;  // of the arguments of an arc
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const bool is_sign = c == '-' || c == '+';
    const std::size_t length = length_of_number(text.substr(i + (is_sign ? 1 : 0)));
    if (length == 0) {
      if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
        is_arc = c == 'a' || c == 'A';
        number = 0;
      }
      ++i;
      continue;
    }
    const int argument = number++ % 7;
    if (is_arc && argument < 2 && c == '-') result[i] = ' ';
    const bool is_flag = is_arc && (argument == 3 || argument == 4);
    i += is_flag ? 1 : length + (is_sign ? 1 : 0);
  }
  return result;
}

}  // namespace

void parse_path_data(std::string_view text, PathBuilder& path) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin != std::string_view::npos &&
      text.substr(begin, text.find_last_not_of(blanks) - begin + 1) == "none") {
    return;
  }
  PathEvents events(path);
  const bool has_arcs = text.find_first_of("aA") != std::string_view::npos;
  parse<PathGrammar>(has_arcs ? with_positive_radii(text) : std::string(text), events, "path data");
}

void parse_points(std::string_view text, PathBuilder& path) {
  // What a moveto accepts is a list of points too.
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
  PathEvents events(path);
  parse<PathGrammar>(fmt::format("M{}", text), events, "list of points", 1);
}

Eigen::Affine2d parse_transform(std::string_view text) {
  TransformEvents events;
  parse<svgpp::transform_grammar<const char*, TransformEvents>>(text, events, "transformation");
  return events.product;
}

std::optional<Colour> parse_colour(std::string_view text) {
  // The parser of names knows ASCII only, and asserts it.
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 128; };
  if (!std::all_of(text.begin(), text.end(), is_ascii)) return std::nullopt;
  const char* position = text.data();
  const char* const end = text.data() + text.size();
  int rgb = 0;
  if (!svgpp::detail::parse_color<svgpp::factory::color::integer<>>(
          position, end, svgpp::tag::source::css(), rgb) ||
      position != end) {
    return std::nullopt;
  }
  const auto component = [&](int shift) { return ((rgb >> shift) & 255) / 255.0; };
  return Colour{component(16), component(8), component(0)};
}

}  // namespace wavecurve::io
