#include "wavecurve/io/animations/detail/write_frames.hpp"

#include <cerrno>
#include <cstdlib>
#include <regex>
#include <string>
#include <sys/stat.h>
#include <system_error>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/png.hpp"
#include "wavecurve/io/animations/detail/render_frames.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write_folder(const fs::path& folder, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write " + folder.string());
}

/// A folder beside the target that is gone when this is, unless it was renamed.
class FolderBeside {
 public:
  explicit FolderBeside(const fs::path& target) : name_(target.string() + ".XXXXXX") {
    if (::mkdtemp(name_.data()) == nullptr) cannot_write_folder(target, errno);
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::chmod(name_.c_str(), 0777 & ~mask);
  }
  FolderBeside(const FolderBeside&) = delete;
  FolderBeside& operator=(const FolderBeside&) = delete;
  ~FolderBeside() {
    std::error_code ignored;
    fs::remove_all(name_, ignored);
  }
  fs::path path() const { return name_; }

 private:
  std::string name_;
};

/// Whether there is a folder; one that holds anything but frames, or no folder at all, is refused.
bool replaces_frames(const fs::path& folder) {
  if (!fs::exists(folder)) return false;
  if (!fs::is_directory(folder)) cannot_write_folder(folder, ENOTDIR);
  // std::regex recurses on the length of its input; the name of a file has at most 255 bytes.
  const std::regex frame("frame-[0-9]+\\.png");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!std::regex_match(entry.path().filename().string(), frame))
      cannot_write_folder(folder, ENOTEMPTY);
  }
  return true;
}

}  // namespace

void write_frames(const fs::path& folder, const motion::Animation& animation,
                  const OutputOptions& options) {
  // A trailing slash is no part of the name.
  const fs::path target = folder.has_filename() ? folder : folder.parent_path();
  const bool replaces = replaces_frames(target);
  const FolderBeside beside(target);
  int number = 0;
  render_frames(animation, options, [&](const Raster& raster) {
    write_file(beside.path() / fmt::format("frame-{:04}.png", ++number), png(raster));
  });
  std::error_code error;
  if (replaces) fs::remove_all(target, error);
  if (!error) fs::rename(beside.path(), target, error);
  if (error) cannot_write_folder(target, error.value());
}

}  // namespace wavecurve::io
