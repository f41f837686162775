#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/io/files/detail/open_file.hpp"

#include "verification/study/study_point.hpp"

namespace wavecurve::verification {

/// The finished points of a study in a file, so that a run that is interrupted, by whatever, is
/// taken up where it ended. A line is a JSON object, that of to_json_line with one member more at
/// its end: "crc32", the CRC-32 of all that stands before this member, as 8 hexadecimal digits. A
/// line without the right one is not believed. The file is for one run at a time; it may be larger
/// than the memory.
class StudyJournal {
 public:
  /// Makes the file if there is none. Throws std::system_error naming the path if it cannot be read or
  /// written, or if another run has it; std::invalid_argument if it is no plain file.
  explicit StudyJournal(const std::filesystem::path& path);

  /// Gives the points that are there and are believed to `take`, one after the other. What an
  /// interrupted write has left at the file's end is cut off; any other line that is not believed stays
  /// where it is, and its point is measured anew.
  /// A journal of a version before has no checksums; its points are measured anew.
  /// Throws std::invalid_argument if what is there is no journal, that is, has lines but not one that
  /// begins as a point's does: nothing is done to it then. Throws std::system_error naming the path.
  void read(const std::function<void(StudyPoint)>& take);

  /// What was not believed when it was read, a sentence on each kind.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// After all that is there, which must have been read before. Throws std::system_error naming the
  /// path.
  void append(const StudyPoint& point);

 private:
  /// Calls `line` with each whole line and its number; what is behind the last is returned.
  std::string for_each_line(const std::function<void(std::string_view, std::size_t)>& line);
  void warn(const char* what, std::size_t count, const std::vector<std::size_t>& first_lines);

  std::filesystem::path path_;
  io::OpenFile file_;
  std::vector<std::string> warnings_;
};

}  // namespace wavecurve::verification
