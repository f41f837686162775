#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/study/solver_study.hpp"

namespace wavecurve::verification {

/// The finished points of a study in a file, one line of JSON each (to_json_line), so that a run
/// that is interrupted, by whatever, is taken up where it ended.
class StudyJournal {
 public:
  /// Makes the file if there is none. What an interrupted write has left at its end, and every line
  /// that is no point, is ignored; the former is cut off. Throws std::system_error naming the path
  /// if it cannot be read or written.
  explicit StudyJournal(const std::filesystem::path& path);
  ~StudyJournal();
  StudyJournal(const StudyJournal&) = delete;
  StudyJournal& operator=(const StudyJournal&) = delete;

  /// Those that were there.
  const std::vector<StudyPoint>& points() const { return points_; }

  /// By one write, after all that is there. Throws std::system_error naming the path.
  void append(const StudyPoint& point);

 private:
  std::string path_;
  std::vector<StudyPoint> points_;
  int file_ = -1;
};

}  // namespace wavecurve::verification
