#include "verification/tables/published_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "wavecurve/io/files/detail/text.hpp"
#include "wavecurve/io/files/read_file.hpp"

#include "verification/prints/number_forms.hpp"
#include "verification/prints/text_encoding.hpp"
#include "verification/tables/table_columns.hpp"

namespace wavecurve::verification {

namespace {

constexpr std::size_t longest_line = 10000;  // a page of a book holds fewer characters
constexpr std::size_t longest_name = 1000;   // a filter may be a path

std::string checked_filter(std::string name) {
  if (name.empty()) throw std::invalid_argument("the filter's name is missing");
  if (name.size() > longest_name) {
    throw std::invalid_argument("the filter's name " + excerpt(name) + " is longer than " +
                                std::to_string(longest_name) + " characters");
  }
  return name;
}

/// The text behind "# key:", if the comment is of that form.
std::optional<std::string> comment_value(std::string_view comment, std::string_view key) {
  const std::string_view rest = io::trimmed(comment.substr(1));
  const auto colon = rest.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  if (io::lower_case(io::trimmed(rest.substr(0, colon))) != key) return std::nullopt;
  return std::string(io::trimmed(rest.substr(colon + 1)));
}

void refuse_binary(std::string_view line) {
  const bool binary = std::any_of(line.begin(), line.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t') || byte == 0x7f;
  });
  if (binary) {
    throw std::invalid_argument("the line has control characters, this is no text table: " +
                                excerpt(line));
  }
}

/// A file has one decimal mark.
class DecimalMarks {
 public:
  /// The mark of a number; a comma is one where it does not separate the columns.
  DecimalMark of(std::string_view printed, char separator) {
    if (separator == ',') return DecimalMark::point;
    for (const char mark : {'.', ','}) {
      if (printed.find(mark) == std::string_view::npos) continue;
      if (mark_ != '\0' && mark_ != mark) {
        throw std::invalid_argument(excerpt(printed) + " has a decimal " +
                                    (mark == ',' ? "comma" : "point") +
                                    ", but a number above the other mark");
      }
      mark_ = mark;
    }
    return DecimalMark::comma;
  }

 private:
  char mark_ = '\0';
};

/// Reads line by line and remembers what has been seen.
class Reader {
 public:
  explicit Reader(const std::string& file) { table_.file = file; }

  void read(std::string_view bytes) {
    try {
      const std::string text = to_utf8(bytes);
      for_each_text_line(text, [this](std::string_view line, int number) {
        line_ = number;
        read_line(line);
      });
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }

  PublishedTable finish() {
    if (!columns_) fail("the table is empty: it needs the header filter,quantity,index,printed");
    if (table_.entries.empty()) fail("the table has a header and no rows");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(table_.file + ":" + std::to_string(line_) + ": " + what);
  }

  void read_line(std::string_view line) {
    if (line.size() > longest_line) {
      throw std::invalid_argument("the line has " + std::to_string(line.size()) +
                                  " characters, at most " + std::to_string(longest_line) +
                                  " are read");
    }
    refuse_binary(line);
    if (io::trimmed(line).empty()) return;
    if (io::trimmed(line).starts_with('#')) {
      read_comment(io::trimmed(line));
    } else if (!columns_) {
      columns_ = parse_table_columns(line);
      table_.extra_columns = columns_->extra_names;
    } else {
      add(parse_entry(line));
    }
  }

  void read_comment(std::string_view comment) {
    if (const auto title = comment_value(comment, "title")) table_.title = *title;
    if (const auto source = comment_value(comment, "source")) table_.source = *source;
    if (const auto words = comment_value(comment, "convention")) {
      table_.convention = parse_convention(*words);
    }
    if (const auto filter = comment_value(comment, "filter")) filter_ = checked_filter(*filter);
    if (const auto quantity = comment_value(comment, "quantity")) {
      quantity_ = parse_quantity(*quantity);
    }
  }

  PublishedEntry parse_entry(std::string_view line) {
    std::vector<std::string> fields = parse_table_row(line, *columns_);
    PublishedEntry entry;
    entry.line = line_;
    entry.filter = columns_->filter ? std::move(fields[*columns_->filter]) : "";
    if (entry.filter.empty() && filter_) entry.filter = *filter_;
    if (!columns_->filter && !filter_) refuse_lacking("filter", "db4");
    entry.filter = checked_filter(std::move(entry.filter));
    if (columns_->quantity && !(quantity_ && fields[*columns_->quantity].empty())) {
      entry.quantity = parse_quantity(fields[*columns_->quantity]);
    } else if (quantity_) {
      entry.quantity = *quantity_;
    } else {
      refuse_lacking("quantity", "h");
    }
    entry.index = parse_entry_index(fields[columns_->index]);
    entry.printed = std::move(fields[columns_->printed]);
    entry.number =
        parse_printed_number(entry.printed, marks_.of(entry.printed, columns_->separator));
    for (const std::size_t place : columns_->extra) entry.extra.push_back(std::move(fields[place]));
    return entry;
  }

  [[noreturn]] static void refuse_lacking(const std::string& column, const std::string& example) {
    throw std::invalid_argument("the header has no column '" + column +
                                "', and no line above says '# " + column + ": " + example +
                                "' or the like");
  }

  void add(PublishedEntry entry) {
    if (table_.entries.size() >= most_rows) {
      throw std::invalid_argument("the table has more than " + std::to_string(most_rows) + " rows");
    }
    const auto filter = filters_.emplace(entry.filter, filters_.size()).first->second;
    const auto [seen, is_new] =
        seen_.emplace(std::tuple(filter, to_string(entry.quantity), entry.index), line_);
    if (!is_new) {
      throw std::invalid_argument("the row repeats line " + std::to_string(seen->second));
    }
    table_.entries.push_back(std::move(entry));
  }

  PublishedTable table_;
  int line_ = 1;
  std::optional<TableColumns> columns_;
  std::optional<std::string> filter_;  ///< of rows that name none
  std::optional<Quantity> quantity_;
  DecimalMarks marks_;
  std::map<std::string, std::size_t> filters_;
  std::map<std::tuple<std::size_t, std::string, EntryIndex>, int> seen_;
};

}  // namespace

std::string PublishedTable::location(const PublishedEntry& entry) const {
  return file + ":" + std::to_string(entry.line) + ": ";
}

PublishedTable parse_published_table(std::string_view text, const std::string& file) {
  Reader reader(file);
  reader.read(text);
  return reader.finish();
}

PublishedTable read_published_table(const std::filesystem::path& path) {
  return parse_published_table(io::read_file(path, largest_table), path.string());
}

}  // namespace wavecurve::verification
