#include "verification/tables/published_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::verification {

namespace {

constexpr std::array<std::string_view, 4> column_names{"filter", "quantity", "index", "printed"};
constexpr std::size_t longest_line = 10000;  // a page of a book holds fewer characters
constexpr std::size_t longest_name = 1000;   // a filter may be a path

/// Where each of column_names stands in the header.
using Header = std::array<std::size_t, column_names.size()>;

Header parse_header(std::string_view line) {
  const std::vector<std::string> fields = io::csv_fields(line);
  Header header{};
  for (std::size_t column = 0; column < column_names.size(); ++column) {
    const auto count = std::count(fields.begin(), fields.end(), column_names[column]);
    const std::string name = "column '" + std::string(column_names[column]) + "'";
    if (count == 0) {
      throw std::invalid_argument("the header has no " + name +
                                  "; a table starts with the line filter,quantity,index,printed");
    }
    if (count > 1) throw std::invalid_argument("the header has " + name + " twice");
    const auto place = std::find(fields.begin(), fields.end(), column_names[column]);
    header[column] = static_cast<std::size_t>(place - fields.begin());
  }
  if (fields.size() > column_names.size()) {
    throw std::invalid_argument("the header has " + std::to_string(fields.size()) +
                                " columns, four are known: filter,quantity,index,printed");
  }
  return header;
}

PublishedEntry parse_entry(std::string_view line, const Header& header) {
  std::vector<std::string> fields = io::csv_fields(line);
  if (fields.size() != header.size()) {
    throw std::invalid_argument("the row has " + std::to_string(fields.size()) +
                                (fields.size() == 1 ? " field" : " fields") +
                                ", the header has 4 columns");
  }
  PublishedEntry entry;
  entry.filter = std::move(fields[header[0]]);
  if (entry.filter.empty()) throw std::invalid_argument("the filter's name is missing");
  if (entry.filter.size() > longest_name)
    throw std::invalid_argument("the filter's name is too long");
  entry.quantity = parse_quantity(fields[header[1]]);
  entry.index = parse_entry_index(fields[header[2]]);
  entry.printed = std::move(fields[header[3]]);
  entry.number = parse_printed_number(entry.printed);
  return entry;
}

/// The text behind "# key:", if the comment is of that form.
std::optional<std::string> comment_value(std::string_view line, std::string_view key) {
  std::string_view rest = io::trimmed(line.substr(1));
  if (!rest.starts_with(key)) return std::nullopt;
  rest.remove_prefix(key.size());
  if (!rest.starts_with(':')) return std::nullopt;
  return std::string(io::trimmed(rest.substr(1)));
}

void refuse_binary(std::string_view line) {
  const bool binary = std::any_of(line.begin(), line.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t') || byte == 0x7f;
  });
  if (binary) throw std::invalid_argument("the line has control characters: this is no text table");
}

/// Reads line by line and remembers what has been seen.
class Reader {
 public:
  explicit Reader(const std::string& file) { table_.file = file; }

  void read_line(std::string_view line) {
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    try {
      if (line.size() > longest_line) {
        throw std::invalid_argument("the line has " + std::to_string(line.size()) +
                                    " characters, at most " + std::to_string(longest_line) +
                                    " are read");
      }
      refuse_binary(line);
      read_content(line);
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

  PublishedTable finish() {
    line_ = std::max(line_, 1);
    if (!header_) fail("the table is empty: it needs the header filter,quantity,index,printed");
    if (table_.entries.empty()) fail("the table has a header and no rows");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(table_.file + ":" + std::to_string(line_) + ": " + what);
  }

  void read_content(std::string_view line) {
    if (io::trimmed(line).empty()) return;
    if (line.starts_with('#')) {
      if (const auto title = comment_value(line, "title")) table_.title = *title;
      if (const auto words = comment_value(line, "convention")) {
        table_.convention = parse_convention(*words);
      }
      if (const auto source = comment_value(line, "source")) table_.source = *source;
    } else if (!header_) {
      header_ = parse_header(line);
    } else {
      add(parse_entry(line, *header_));
    }
  }

  void add(PublishedEntry entry) {
    entry.line = line_;
    const auto [seen, is_new] =
        seen_.emplace(std::tuple(entry.filter, to_string(entry.quantity), entry.index), line_);
    if (!is_new) {
      throw std::invalid_argument("the row repeats line " + std::to_string(seen->second));
    }
    table_.entries.push_back(std::move(entry));
  }

  PublishedTable table_;
  int line_ = 0;
  std::optional<Header> header_;
  std::map<std::tuple<std::string, std::string, EntryIndex>, int> seen_;
};

}  // namespace

std::string PublishedTable::location(const PublishedEntry& entry) const {
  return file + ":" + std::to_string(entry.line) + ": ";
}

PublishedTable parse_published_table(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Reader reader(file);
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    reader.read_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.finish();
}

PublishedTable read_published_table(const std::filesystem::path& path) {
  return parse_published_table(io::read_file(path), path.string());
}

}  // namespace wavecurve::verification
