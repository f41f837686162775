#pragma once

#include <filesystem>
#include <mutex>
#include <sys/types.h>

namespace wavecurve::io {

/// The temporary files and folders and the child processes of this program: what must not outlive
/// it. Whoever makes one, or finishes it, holds an object of this class meanwhile, and one thread at
/// a time does. So a program that is told to end takes the object, calls abandon(), and ends with
/// it in its hand: nothing is half made then, and nothing is made any more.
class Unfinished {
 public:
  Unfinished();

  void add(const std::filesystem::path& temporary);
  void forget(const std::filesystem::path& temporary);
  void add(pid_t child);
  void forget(pid_t child);

  /// Removes what is there of it, and forgets it.
  void remove(const std::filesystem::path& temporary);

  /// Ends the child processes with all that they started (each leads a process group): by SIGTERM,
  /// and after two seconds by SIGKILL. Then removes the temporary files and folders.
  void abandon();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace wavecurve::io
