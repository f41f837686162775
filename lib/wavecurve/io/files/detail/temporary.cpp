#include "wavecurve/io/files/detail/temporary.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <set>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "wavecurve/io/files/detail/unfinished.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".wavecurve-";

[[noreturn]] void cannot_write(const fs::path& target, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write " + target.string());
}

/// No two threads are here at once, for each holds Unfinished.
fs::path next_name(const fs::path& folder) {
  static long count = 0;
  return folder /
         (std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(++count));
}

bool is_name_of_ours(std::string_view name) {
  if (!name.starts_with(prefix)) return false;
  name.remove_prefix(prefix.size());
  const auto is_number = [](std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::size_t dash = name.find('-');
  return dash != std::string_view::npos && is_number(name.substr(0, dash)) &&
         is_number(name.substr(dash + 1));
}

void remove_if_stale(const fs::path& path) {
  const int flags = O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
  const OpenFile found(::open(path.c_str(), flags));
  struct stat status {};
  if (!found.is_open() || ::fstat(found.number(), &status) != 0) return;
  if (status.st_uid != ::geteuid() || !(S_ISREG(status.st_mode) || S_ISDIR(status.st_mode))) return;
  if (::flock(found.number(), LOCK_EX | LOCK_NB) != 0) return;
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

/// The first time that this program makes a temporary in the folder.
void remove_what_is_stale(const fs::path& folder) {
  static auto& cleaned = *new std::set<fs::path>;
  if (!cleaned.insert(folder).second) return;
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (is_name_of_ours(entry->path().filename().string())) remove_if_stale(entry->path());
  }
}

/// Makes a new file or folder, as permissive as the system makes any. Not open: it could not be made.
OpenFile make_new(const fs::path& path, Temporary::Kind kind, mode_t permissions) {
  if (kind == Temporary::Kind::file) {
    const int flags = O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC;
    return OpenFile(::open(path.c_str(), flags, permissions));
  }
  if (::mkdir(path.c_str(), permissions) != 0) return {};
  OpenFile folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.is_open()) {
    const int error = errno;
    ::rmdir(path.c_str());
    errno = error;
  }
  return folder;
}

/// False if another program took it for stale in the moment before it was locked. A file system
/// without locks removes nothing that is stale, and so nothing that is not.
bool lock(const OpenFile& made) {
  struct stat status {};
  const bool is_taken = ::flock(made.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return !is_taken && ::fstat(made.number(), &status) == 0 && status.st_nlink > 0;
}

}  // namespace

Temporary::Temporary(const fs::path& target, Kind kind) : target_(target), kind_(kind) {
  struct stat status {};
  const bool replaces = ::stat(target_.c_str(), &status) == 0;
  const mode_t plain = kind == Kind::file ? 0666 : 0777;
  // Never wider open than what is replaced; but we must be able to write into a folder.
  make(replaces ? (status.st_mode & plain) | (plain & 0700) : plain);
}

void Temporary::make(mode_t permissions) {
  const fs::path folder = target_.parent_path();
  Unfinished unfinished;
  remove_what_is_stale(folder);
  while (!descriptor_.is_open()) {
    path_ = next_name(folder);
    OpenFile made = make_new(path_, kind_, permissions);
    if (!made.is_open() && errno == EEXIST) continue;
    if (!made.is_open()) cannot_write(target_, errno);
    if (lock(made)) descriptor_ = std::move(made);
  }
  unfinished.add(path_);
}

Temporary::~Temporary() {
  if (path_.empty()) return;
  Unfinished().remove(path_);
}

void Temporary::keep() {
  if (kind_ == Kind::file) {
    struct stat old {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    if (replaces && ::fchmod(descriptor(), old.st_mode & 07777) != 0) cannot_write(target_, errno);
    if (::fsync(descriptor()) != 0) cannot_write(target_, errno);
  }
  Unfinished unfinished;
  if (::rename(path_.c_str(), target_.c_str()) != 0) cannot_write(target_, errno);
  unfinished.forget(path_);
  path_.clear();
}

bool Temporary::exchange(const std::function<void()>& check) {
  const auto change_places = [this] {
    return ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0;
  };
  Unfinished unfinished;
  if (!change_places()) {
    if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) cannot_write(target_, errno);
    return false;
  }
  try {
    check();
    return true;
  } catch (...) {
    if (!change_places()) {  // it is not ours to be removed
      unfinished.forget(path_);
      path_.clear();
    }
    throw;
  }
}

}  // namespace wavecurve::io
