#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"

namespace wavecurve::io {

/// A folder into which several files are written that belong together. They are made in a temporary
/// folder inside, and put in their places by publish(): all of them, or after a failure none. A
/// folder that was made for them and stays empty is removed. One run at a time (FolderLock).
class OutputFolder {
 public:
  /// Makes the folder if need be. Throws std::system_error naming it.
  explicit OutputFolder(const std::filesystem::path& folder);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  /// Where the files are to be written, in subfolders too.
  const std::filesystem::path& staging() const { return staging_->path(); }

  /// Syncs all files, and renames one after the other over the older ones: those in subfolders, then
  /// the others, by name. If one of the renames fails, those before it are undone (where the file
  /// system has hard links, by which the older files are kept meanwhile); a program that is told to
  /// end does so before the first or after the last. Only a program that is killed within leaves some
  /// old and some new files, each whole. Other files of the folder stay. Throws std::system_error.
  void publish();

 private:
  struct Step {
    std::filesystem::path target, old;  ///< old: empty if there was none, or it could not be kept
    bool replaces;
  };
  void put_in_place(const std::filesystem::path& file);
  void undo();
  void remove_made_folders();
  void make_folders(const std::filesystem::path& folder);

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_folders_;
  std::optional<FolderLock> lock_;
  std::optional<Temporary> staging_;
  std::vector<Step> steps_;
};

}  // namespace wavecurve::io
