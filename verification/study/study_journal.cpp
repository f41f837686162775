#include "verification/study/study_journal.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

#include "wavecurve/io/files/read_file.hpp"

#include "verification/study/study_json.hpp"

namespace wavecurve::verification {

namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path) {
  throw std::system_error(errno, std::generic_category(), what + " " + path);
}

std::vector<StudyPoint> points_of(const std::string& text) {
  std::vector<StudyPoint> points;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    try {
      points.push_back(point_of_json_line(line));
    } catch (const std::invalid_argument&) {  // of another version: computed again
    }
  }
  return points;
}

}  // namespace

StudyJournal::StudyJournal(const std::filesystem::path& path) : path_(path.string()) {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail("cannot open", path_);
  std::string text = io::read_file(path);
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  if (::ftruncate(file_, static_cast<off_t>(text.size())) != 0) fail("cannot shorten", path_);
  points_ = points_of(text);
}

StudyJournal::~StudyJournal() {
  if (file_ >= 0) ::close(file_);
}

void StudyJournal::append(const StudyPoint& point) {
  const std::string line = to_json_line(point) + "\n";
  const ssize_t written = ::write(file_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size())) return;
  if (written >= 0) errno = ENOSPC;  // the only reason for less
  fail("cannot write", path_);
}

}  // namespace wavecurve::verification
