#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/io/files/detail/open_file.hpp"

#include "verification/study/solver_study.hpp"

namespace wavecurve::verification {

/// The finished points of a study in a file, so that a run that is interrupted, by whatever, is
/// taken up where it ended. A line is a JSON object, that of to_json_line with one member more at
/// its end: "crc32", the CRC-32 of all that stands before this member, as 8 hexadecimal digits. A
/// line without the right one is not believed. The file is for one run at a time.
class StudyJournal {
 public:
  /// Makes the file if there is none. What an interrupted write has left at its end is cut off; any
  /// other line that is not believed stays where it is, and its point is measured anew.
  /// A journal of a version before has no checksums; its points are measured anew.
  /// Throws std::invalid_argument if what is there is no journal, that is, has lines but not one that
  /// begins as a point's does: nothing is done to it then.
  /// Throws std::system_error naming the path if it cannot be read or written, or if another run has it.
  explicit StudyJournal(const std::filesystem::path& path);

  /// Those that were there and are believed.
  const std::vector<StudyPoint>& points() const { return points_; }

  /// What was not believed, a sentence on each kind.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// After all that is there. Throws std::system_error naming the path.
  void append(const StudyPoint& point);

 private:
  void read();
  void take(std::string_view text);
  void warn(const char* what, const std::vector<std::size_t>& lines);

  std::filesystem::path path_;
  io::OpenFile file_;
  std::vector<StudyPoint> points_;
  std::vector<std::string> warnings_;
};

}  // namespace wavecurve::verification
