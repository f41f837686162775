#include "wavecurve/io/files/detail/folder_lock.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>

namespace wavecurve::io {

namespace {

/// The folder may have given its place to another one before it was locked.
bool is_at(const std::filesystem::path& path, const OpenFile& descriptor) {
  struct stat there {
  }, here{};
  return ::stat(path.c_str(), &there) == 0 && ::fstat(descriptor.number(), &here) == 0 &&
         there.st_dev == here.st_dev && there.st_ino == here.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, IfLocked if_locked) {
  do {
    descriptor_ = OpenFile(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!descriptor_.is_open()) {
      throw std::system_error(errno, std::generic_category(), "cannot open " + folder.string());
    }
    lock_for_this_run(descriptor_, folder, if_locked);
  } while (!is_at(folder, descriptor_));
}

void lock_for_this_run(const OpenFile& descriptor, const std::filesystem::path& path,
                       IfLocked if_locked) {
  const int how = if_locked == IfLocked::wait ? LOCK_EX : LOCK_EX | LOCK_NB;
  int result = 0;
  while ((result = ::flock(descriptor.number(), how)) != 0 && errno == EINTR) {
  }
  if (result == 0 || errno != EWOULDBLOCK) return;
  throw std::system_error(std::make_error_code(std::errc::device_or_resource_busy),
                          "another run is writing to " + path.string());
}

}  // namespace wavecurve::io
