#include "verification/study/study_journal.hpp"

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

/// A line of ours has some 2,000 characters at most, its names of files included.
constexpr std::size_t longest_line = std::size_t{1} << 20;

/// The numbers of lines that are not believed: all are counted, the first are named.
struct Disbelieved {
  static constexpr std::size_t most = 5;
  std::size_t count = 0;
  std::vector<std::size_t> first;

  void add(std::size_t number) {
    if (++count <= most) first.push_back(number);
  }
};

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
}

std::string StudyJournal::for_each_line(
    const std::function<void(std::string_view, std::size_t)>& line) {
  std::string text;
  std::vector<char> bytes(std::size_t{1} << 18);
  std::size_t number = 0;
  for (off_t offset = 0;;) {
    const ssize_t count = ::pread(file_.number(), bytes.data(), bytes.size(), offset);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot read", path_);
    if (count == 0) return text;
    offset += count;
    text.append(bytes.data(), static_cast<std::size_t>(count));
    std::size_t start = 0;
    for (std::size_t end = 0; (end = text.find('\n', start)) != std::string::npos;
         start = end + 1) {
      line(std::string_view(text).substr(start, end - start), ++number);
    }
    text.erase(0, start);
    if (text.size() > longest_line) {
      throw std::invalid_argument(
          fmt::format("{} is no journal of a study: line {} has more than {} characters",
                      path_.string(), number + 1, longest_line));
    }
  }
}

void StudyJournal::read(const std::function<void(StudyPoint)>& take) {
  warnings_.clear();
  Disbelieved altered, without;
  bool is_journal = false;
  off_t whole = 0;
  const std::string torn = for_each_line([&](std::string_view text, std::size_t number) {
    whole += static_cast<off_t>(text.size() + 1);
    is_journal = is_journal || text.starts_with(beginning);
    JournalLine line = line_of(text);
    if (line.belief == Belief::none) altered.add(number);
    if (line.belief == Belief::of_a_version_before) without.add(number);
    if (line.belief == Belief::whole && line.point) take(std::move(*line.point));
  });
  const bool is_torn_in_the_first = whole == 0 && beginning.starts_with(torn);
  if (!is_journal && !torn.starts_with(beginning) && !is_torn_in_the_first) {
    throw std::invalid_argument(path_.string() +
                                " is no journal of a study: none of its lines is a point of one");
  }
  warn("altered, or no point of this version", altered.count, altered.first);
  warn("without a checksum, of a version before", without.count, without.first);
  if (torn.empty()) return;
  if (::ftruncate(file_.number(), whole) != 0) fail("cannot shorten", path_);
  warnings_.push_back(path_.string() +
                      ": the last line was not written to its end; its point is measured anew");
}

void StudyJournal::warn(const char* what, std::size_t count,
                        const std::vector<std::size_t>& first_lines) {
  if (count == 0) return;
  const std::size_t more = count - first_lines.size();
  warnings_.push_back(fmt::format("{}: {} {}{} {}; measured anew", path_.string(),
                                  count == 1 ? "line" : "lines", fmt::join(first_lines, ", "),
                                  more > 0 ? fmt::format(" and {} more", more) : "", what));
}

void StudyJournal::append(const StudyPoint& point) {
  io::write_all(file_.number(), journal_line(point), path_.string());
}

}  // namespace wavecurve::verification
