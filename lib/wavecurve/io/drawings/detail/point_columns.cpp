#include "wavecurve/io/drawings/detail/point_columns.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/table_rows.hpp"
#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

using Names = std::vector<std::string>;

bool is_one(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether one word of a name is among those, and the others say nothing more.
bool is_named(std::string_view name, std::initializer_list<std::string_view> words) {
  int found = 0;
  for (const std::string_view word : split(name, "_")) {
    if (is_one(word, words)) {
      ++found;
    } else if (!is_one(word,
                       {"coord", "coords", "coordinate", "coordinates", "pos", "position", "point",
                        "pt", "location", "loc", "value", "world", "image", "img"})) {
      return false;
    }
  }
  return found == 1;
}

bool is_contour(std::string_view name) {
  auto words = split(name, "_");
  if (words.size() > 1 && is_one(words.back(), {"id", "ids", "name", "no", "nr", "number", "num",
                                                "index", "idx", "label"})) {
    words.pop_back();
  }
  return words.size() == 1 &&
         is_one(words[0],
                {"id",    "contour", "contours", "name",   "label", "shape",    "polygon",
                 "poly",  "ring",    "part",     "parts",  "group", "object",   "obj",
                 "path",  "curve",   "outline",  "roi",    "piece", "limb",     "layer",
                 "cell",  "feature", "geometry", "line",   "loop",  "specimen", "component",
                 "track", "subpath", "stroke",   "segment"});
}

bool is_time(std::string_view name) {
  auto words = split(name, "_");
  if (words.size() > 1 &&
      is_one(words.back(), {"id", "no", "nr", "number", "num", "index", "idx"})) {
    words.pop_back();
  }
  return words.size() == 1 &&
         is_one(words[0], {"t", "time", "times", "frame", "frames", "timestamp", "timestep",
                           "slice", "sec", "seconds", "ms"});
}

bool is_index(std::string_view name) {
  return is_one(name, {"index",     "idx",          "i",           "j",         "k",
                       "n",         "no",           "nr",          "num",       "number",
                       "row",       "point",        "pt",          "vertex",    "node",
                       "order",     "seq",          "sequence",    "unnamed_0", "rownames",
                       "row_names", "point_id",     "point_index", "point_no",  "point_number",
                       "vertex_id", "vertex_index", "node_id",     "landmark",  "row_id"});
}

struct Pair {
  std::initializer_list<std::string_view> x, y;
};

/// The first pair that is there is read.
const Pair pairs[] = {{{"x", "xs", "xcoord", "xpos", "posx", "coordx", "xcoordinate", "pointx"},
                       {"y", "ys", "ycoord", "ypos", "posy", "coordy", "ycoordinate", "pointy"}},
                      {{"lon", "long", "lng", "longitude"}, {"lat", "latitude"}},
                      {{"easting", "east"}, {"northing", "north"}},
                      {{"col", "column"}, {"row"}},
                      {{"u"}, {"v"}}};

/// Where a column of such a name is; of several, that of the bare name.
std::optional<std::size_t> find(const Names& header, const Names& names,
                                std::initializer_list<std::string_view> wanted) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_named(names[i], wanted)) found.push_back(i);
  }
  if (found.empty()) return std::nullopt;
  const auto is_bare = [&](std::size_t i) {
    return lower_case(trimmed(header[i])) == *wanted.begin();
  };
  const auto bare = std::count_if(found.begin(), found.end(), is_bare);
  if (found.size() > 1 && bare != 1) {
    throw std::invalid_argument(fmt::format("two columns are {}: '{}' and '{}'", *wanted.begin(),
                                            shown(header[found[0]]), shown(header[found[1]])));
  }
  return bare == 1 ? *std::find_if(found.begin(), found.end(), is_bare) : found[0];
}

/// The names of exactly two columns that a program has numbered: V1, V2; Var1, Var2; 0, 1.
bool are_numbered(std::string_view first, std::string_view second) {
  if (first.empty() || first.size() != second.size()) return false;
  const std::size_t last = first.size() - 1;
  return first.substr(0, last) == second.substr(0, last) && first[last] >= '0' &&
         first[last] <= '9' && second[last] == first[last] + 1;
}

void find_coordinates(PointColumns& columns, const Names& header, const Names& names) {
  bool has_x = false, has_y = false;
  for (const Pair& pair : pairs) {
    const auto x = find(header, names, pair.x), y = find(header, names, pair.y);
    if (x && y) {
      columns.x = *x;
      columns.y = *y;
      return;
    }
    if (&pair == &pairs[0]) has_x = x.has_value(), has_y = y.has_value();
  }
  const auto at = [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  const auto size = static_cast<std::ptrdiff_t>(names.size());
  if (at("axis_1") < size && at("axis_0") < size) {
    columns.x = static_cast<std::size_t>(at("axis_1"));
    columns.y = static_cast<std::size_t>(at("axis_0"));
    return;
  }
  const std::size_t first = names[0].empty() && names.size() == 3 ? 1 : 0;
  if (names.size() == first + 2 && are_numbered(names[first], names[first + 1])) {
    columns.x = first;
    columns.y = first + 1;
    columns.warnings.push_back(fmt::format("the columns '{}' and '{}' are taken for x and y",
                                           shown(header[first]), shown(header[first + 1])));
    return;
  }
  throw std::invalid_argument(fmt::format("'{}' names no column {}",
                                          shown(fmt::format("{}", fmt::join(header, ","))),
                                          has_x   ? "y"
                                          : has_y ? "x"
                                                  : "x and none y"));
}

/// The columns that a program numbers from 0 on, behind one without a name.
bool is_numbered_header(const Names& row) {
  if (row.size() != 3 || !row[0].empty()) return false;
  return row[1] == "0" && row[2] == "1";
}

}  // namespace

PointColumns point_columns(const std::vector<std::string>& header) {
  Names names;
  for (const std::string& cell : header) names.push_back(column_name(cell));
  PointColumns columns;
  find_coordinates(columns, header, names);
  Names others;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == columns.x || i == columns.y) continue;
    if (!columns.index && ((i == 0 && names[i].empty()) || is_index(names[i]))) {
      columns.index = i;
    } else if (is_contour(names[i])) {
      columns.contour.push_back(i);
    } else if (is_time(names[i])) {
      columns.time.push_back(i);
    } else if (names[i] == "z") {
      columns.warnings.push_back("the column z is not read: a drawing is plane");
    } else if (!names[i].empty()) {
      others.push_back(fmt::format("'{}'", shown(header[i])));
    }
  }
  if (others.size() > 10) {
    const std::size_t rest = others.size() - 10;
    others.resize(10);
    others.push_back(fmt::format("{} more", rest));
  }
  if (!others.empty()) {
    columns.warnings.push_back(fmt::format("the column{} {} {} not read",
                                           others.size() > 1 ? "s" : "", fmt::join(others, ", "),
                                           others.size() > 1 ? "are" : "is"));
  }
  return columns;
}

bool names_coordinates(const std::vector<std::string>& header) {
  try {
    point_columns(header);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

bool is_point_header(const std::vector<std::string>& row, char separator) {
  const auto is_number = [&](const std::string& cell) {
    return cell_number(cell, separator).has_value();
  };
  if (std::none_of(row.begin(), row.end(), is_number) || is_numbered_header(row)) return true;
  Names names;
  for (const std::string& cell : row) names.push_back(column_name(cell));
  return std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return name == "x"; }) &&
         std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return name == "y"; });
}

}  // namespace wavecurve::io
