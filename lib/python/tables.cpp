// Published tables and lists of numbers that nobody named.
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

#include "wavecurve/certified/find_filter.hpp"

#include "python/interruptible.hpp"
#include "python/topics.hpp"
#include "verification/checker/check_table.hpp"
#include "verification/checker/judge_doubles.hpp"
#include "verification/identify/identify.hpp"
#include "verification/identify/number_lists.hpp"
#include "verification/prints/marked_print.hpp"

namespace wavecurve::python {

namespace {

using namespace verification;

py::object to_python(const EntryIndex& index) {
  if (index.is_integer()) return py::int_(index.integer());
  return py::str(index.text());
}

py::list marked(const CheckedRow& row) {
  py::list parts;
  for (const PrintPart& part : marked_print(row.entry.printed, row.entry.number, row.departure)) {
    parts.append(py::make_tuple(part.text, part.departs));
  }
  return parts;
}

py::dict to_python(const CheckedRow& row) {
  py::dict result;
  result["filter"] = row.entry.filter;
  result["quantity"] = to_string(row.entry.quantity);
  result["index"] = to_python(row.entry.index);
  result["printed"] = row.entry.printed;
  result["verdict"] = std::string(to_string(row.verdict));
  result["certified"] = row.certified;
  result["ulps"] = row.ulps;
  result["detail"] = row.detail;
  result["route"] = row.route;
  result["marked"] = marked(row);
  result["extra"] = row.entry.extra;
  return result;
}

py::dict to_python(const CheckedColumn& column) {
  py::dict result;
  result["filter"] = column.filter;
  result["quantity"] = to_string(column.quantity);
  result["convention"] = column.convention_text;
  result["known_as"] = column.known_as;
  result["stated"] = column.convention.stated;
  result["solution"] = column.solution;
  result["digits"] = column.digits;
  result["scientific"] = column.scientific;
  result["route"] = column.route;
  result["matched"] = column.matched;
  result["after_edit"] = column.after_edit;
  result["of"] = column.of;
  result["credited"] = column.credited;
  result["chance"] = column.chance;
  return result;
}

py::dict to_python(const CheckedTable& table) {
  py::dict result;
  result["title"] = table.title;
  result["is_right"] = table.is_right();
  result["extra_columns"] = table.extra_columns;
  py::list rows, columns;
  for (const CheckedRow& row : table.rows) rows.append(to_python(row));
  for (const CheckedColumn& column : table.columns) columns.append(to_python(column));
  result["rows"] = rows;
  result["columns"] = columns;
  py::dict counts;
  for (const auto& [verdict, count] : table.counts()) {
    counts[py::str(std::string(to_string(verdict)))] = count;
  }
  result["counts"] = counts;
  return result;
}

/// Doubles that are the nearest to the true values are right, whatever their digits.
py::dict check_text(const std::string& text, const std::string& name, bool are_doubles) {
  return to_python(interruptible([=] {
    CheckedTable table = check_table(parse_published_table(text, name));
    return are_doubles ? judged_as_doubles(std::move(table)) : table;
  }));
}

py::dict check_file(const std::filesystem::path& path) {
  return to_python(interruptible([path] { return check_table(read_published_table(path)); }));
}

struct IdentifiedList {
  NumberList list;
  std::vector<Match> matches;
  std::vector<NearMiss> nearest;
  std::vector<std::string> known_as;  ///< the package that prints the match so, of each
};

/// The match names a package only where the list is the column of one.
std::string package_of(const Match& match) {
  if (!match.in_order || match.convention.shift != 0 || match.convention.half_powers != 0) {
    return "";
  }
  FilterValues filter(certified::find_filter(match.column->filter));
  return known_as(filter, match.column->quantity, match.convention);
}

std::vector<IdentifiedList> identify_all(const std::string& text) {
  std::vector<IdentifiedList> result;
  for (NumberList& list : read_number_lists(text)) {
    IdentifiedList found{std::move(list), {}, {}, {}};
    found.matches = identify(found.list);
    found.nearest = nearest_columns(found.list, found.matches);
    for (const Match& match : found.matches) found.known_as.push_back(package_of(match));
    result.push_back(std::move(found));
  }
  return result;
}

py::dict to_python(const Match& match, const std::string& known_as) {
  py::dict result;
  result["filter"] = match.column->filter;
  result["quantity"] = to_string(match.column->quantity);
  result["reversed"] = match.convention.reversed;
  result["negated"] = match.convention.negated;
  result["alternating"] = match.convention.alternating;
  result["scale"] = scale_text(match);
  result["shift"] = match.convention.shift;
  result["in_order"] = match.in_order;
  result["digits"] = match.digits;
  result["matched"] = match.matched;
  result["of"] = match.of;
  result["known_as"] = known_as;
  return result;
}

py::list identify_text(const std::string& text) {
  const auto lists = interruptible([text] { return identify_all(text); });
  py::list result;
  for (const IdentifiedList& found : lists) {
    py::dict entry;
    py::list matches, nearest;
    for (std::size_t i = 0; i < found.matches.size(); ++i) {
      matches.append(to_python(found.matches[i], found.known_as[i]));
    }
    for (const NearMiss& miss : found.nearest) {
      nearest.append(
          py::make_tuple(miss.column->filter, to_string(miss.column->quantity), miss.distance));
    }
    entry["name"] = found.list.name;
    entry["numbers"] = found.list.numbers.size();
    entry["matches"] = matches;
    entry["nearest"] = nearest;
    result.append(entry);
  }
  return result;
}

}  // namespace

void add_tables(py::module_& module) {
  module.def("check_text", &check_text, py::arg("text"), py::arg("name"), py::arg("are_doubles"));
  module.def("check_file", &check_file, py::arg("path"));
  module.def("identify_text", &identify_text, py::arg("text"));
}

}  // namespace wavecurve::python
