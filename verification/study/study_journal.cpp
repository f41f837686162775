#include "verification/study/study_journal.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <zlib.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/read_file.hpp"

#include "verification/study/study_json.hpp"

namespace wavecurve::verification {

namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path) {
  throw std::system_error(errno, std::generic_category(), what + " " + path.string());
}

/// The member that ends a line. CRC-32 finds every change within 32 neighbouring bits, so up to four
/// digits that were altered, and all but 2^-32 of the others.
std::string checksum_of(std::string_view text) {
  const auto sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
  return fmt::format(",\"crc32\":\"{:08x}\"}}", sum);
}

std::string journal_line(const StudyPoint& point) {
  std::string line = to_json_line(point);
  line.pop_back();  // the closing brace
  return line + checksum_of(line) + "\n";
}

enum class Belief { none, of_a_version_before, whole };

struct JournalLine {
  Belief belief = Belief::none;
  std::optional<StudyPoint> point;
};

JournalLine line_of(std::string_view text) {
  static const std::size_t length = checksum_of("").size();
  JournalLine line;
  if (text.size() > length) {
    const std::string_view before = text.substr(0, text.size() - length);
    if (text.substr(before.size()) == checksum_of(before)) line.belief = Belief::whole;
  }
  try {
    line.point = point_of_json_line(std::string(text));
    const bool summed = text.find("\"crc32\"") != std::string_view::npos;
    if (line.belief == Belief::none && !summed) line.belief = Belief::of_a_version_before;
  } catch (const std::invalid_argument&) {  // altered, or of another version
  }
  return line;
}

/// How every line of ours begins, whatever became of the rest.
constexpr std::string_view beginning = "{\"solver\":";

bool is_journal(std::string_view text) {
  if (beginning.starts_with(text)) return true;  // empty, or torn in the first line
  for (std::size_t start = 0; start < text.size(); start = text.find('\n', start) + 1) {
    if (text.substr(start).starts_with(beginning)) return true;
    if (text.find('\n', start) == std::string_view::npos) break;
  }
  return false;
}

}  // namespace

StudyJournal::StudyJournal(const std::filesystem::path& path)
    : path_(path), file_(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (!file_.is_open()) fail("cannot open", path_);
  struct stat status {};
  if (::fstat(file_.number(), &status) != 0) fail("cannot open", path_);
  if (!S_ISREG(status.st_mode)) {
    throw std::invalid_argument(path_.string() + " is no journal of a study: it is no plain file");
  }
  io::lock_for_this_run(file_, path_);
  read();
}

void StudyJournal::read() {
  const std::string text = io::read_file(path_);
  if (!is_journal(text)) {
    throw std::invalid_argument(path_.string() +
                                " is no journal of a study: none of its lines is a point of one");
  }
  const std::size_t whole = text.rfind('\n') + 1;  // npos + 1 is 0
  take(std::string_view(text).substr(0, whole));
  if (whole == text.size()) return;
  if (::ftruncate(file_.number(), static_cast<off_t>(whole)) != 0) fail("cannot shorten", path_);
  warnings_.push_back(path_.string() +
                      ": the last line was not written to its end; its point is measured anew");
}

void StudyJournal::take(std::string_view text) {
  std::vector<std::size_t> altered, without;
  std::size_t number = 0;
  for (std::size_t start = 0, end = 0; start < text.size(); start = end + 1) {
    end = text.find('\n', start);
    ++number;
    JournalLine line = line_of(text.substr(start, end - start));
    if (line.belief == Belief::none) altered.push_back(number);
    if (line.belief == Belief::of_a_version_before) without.push_back(number);
    if (line.belief == Belief::whole && line.point) points_.push_back(std::move(*line.point));
  }
  warn("altered, or no point of this version", altered);
  warn("without a checksum, of a version before", without);
}

void StudyJournal::warn(const char* what, const std::vector<std::size_t>& lines) {
  if (lines.empty()) return;
  constexpr std::size_t most = 5;
  const std::vector<std::size_t> first(
      lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(std::min(most, lines.size())));
  warnings_.push_back(fmt::format(
      "{}: {} {}{} {}; measured anew", path_.string(), lines.size() == 1 ? "line" : "lines",
      fmt::join(first, ", "),
      lines.size() > most ? fmt::format(" and {} more", lines.size() - most) : "", what));
}

void StudyJournal::append(const StudyPoint& point) {
  io::write_all(file_.number(), journal_line(point), path_.string());
}

}  // namespace wavecurve::verification
