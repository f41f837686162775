#pragma once

#include <filesystem>
#include <functional>
#include <sys/types.h>

#include "wavecurve/io/files/detail/open_file.hpp"

namespace wavecurve::io {

/// A file or a folder beside a target, gone when this is or when the program is told to end
/// (Unfinished), unless it was put in the target's place. Its name is .wavecurve-PID-N, so it does
/// not grow with the target's. While it is in use it is locked (flock); a program that is killed
/// cannot remove it, but loses the lock, and whoever makes the next temporary in that folder removes
/// what is named like one, is ours and is not locked. The number of a process decides nothing, for
/// it may have been given to another process.
/// Everything here throws std::system_error that says that the target cannot be written.
class Temporary {
 public:
  enum class Kind { file, folder };

  Temporary(const std::filesystem::path& target, Kind kind);
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary();

  const std::filesystem::path& path() const { return path_; }
  /// A file is open for reading and writing, a folder for locking only.
  int descriptor() const { return descriptor_.number(); }

  /// Renames this to the target, and over an older file. A file is synced before, and has the
  /// permissions of the file that it replaces.
  void keep();

  /// This and the target, which is there, change places at once; what was the target is then the
  /// temporary, and goes with it, unless `check` throws: then they change back. False where the file
  /// system has no such operation; nothing has happened then.
  bool exchange(const std::function<void()>& check);

 private:
  void make(mode_t permissions);

  std::filesystem::path target_, path_;
  Kind kind_;
  OpenFile descriptor_;
};

}  // namespace wavecurve::io
