#pragma once

#include <filesystem>

#include "wavecurve/io/files/detail/open_file.hpp"

namespace wavecurve::io {

/// What a run does that finds a folder locked.
enum class IfLocked { refuse, wait };

/// Keeps a folder to one run at a time, from here on until this is gone (flock; nothing is left in
/// the folder). A file system without locks locks nothing.
class FolderLock {
 public:
  /// Throws std::system_error naming the folder if another run has it, unless it is to be waited
  /// for, or if it cannot be opened.
  explicit FolderLock(const std::filesystem::path& folder, IfLocked if_locked = IfLocked::refuse);

 private:
  OpenFile descriptor_;
};

/// Locks what is open, in the same way; `path` is named in what is thrown.
void lock_for_this_run(const OpenFile& descriptor, const std::filesystem::path& path,
                       IfLocked if_locked = IfLocked::refuse);

}  // namespace wavecurve::io
