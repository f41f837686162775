#include "wavecurve/io/animations/detail/write_frames.hpp"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/png.hpp"
#include "wavecurve/io/animations/detail/render_frames.hpp"
#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/detail/output_path.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"
#include "wavecurve/io/files/detail/unfinished.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write_frames(const fs::path& folder, const std::string& reason,
                                      int error) {
  throw std::system_error(error, std::generic_category(),
                          "cannot write " + folder.string() + reason);
}

/// frame-0001.png to frame-9999.png, and on from frame-10000.png.
bool is_frame_name(std::string_view name) {
  constexpr std::string_view before = "frame-", after = ".png";
  if (!name.starts_with(before) || !name.ends_with(after)) return false;
  if (name.size() < before.size() + 4 + after.size()) return false;
  name = name.substr(before.size(), name.size() - before.size() - after.size());
  const bool is_number = std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
  return is_number && (name.size() == 4 || name.front() != '0');
}

/// Refuses a folder that holds anything but frames: it is to be removed.
void check_holds_frames_only(const fs::path& folder, const fs::path& named) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!is_frame_name(name) || !fs::is_regular_file(entry.symlink_status())) {
      cannot_write_frames(named, ": it holds " + name + ", which is no frame of ours", ENOTEMPTY);
    }
  }
}

fs::path put_aside(const fs::path& folder) { return folder.string() + ".wavecurve-old"; }

/// A run that ended between two renames has left the old frames aside.
void recover(const fs::path& folder) {
  const fs::path aside = put_aside(folder);
  if (!fs::is_directory(fs::symlink_status(aside))) return;
  const FolderLock lock(aside);
  if (!fs::exists(fs::symlink_status(folder))) return fs::rename(aside, folder);
  check_holds_frames_only(aside, aside);
  fs::remove_all(aside);
}

void replace_in_two_steps(Temporary& frames, const fs::path& folder) {
  const fs::path aside = put_aside(folder);
  Unfinished both_renames_or_none;
  fs::rename(folder, aside);
  try {
    check_holds_frames_only(aside, folder);
    frames.keep();
  } catch (...) {
    fs::rename(aside, folder);
    throw;
  }
  both_renames_or_none.remove(aside);
}

void replace(Temporary& frames, const fs::path& folder) {
  // What came into the old folder meanwhile must not be removed with it.
  const bool exchanged = frames.exchange([&] { check_holds_frames_only(frames.path(), folder); });
  if (!exchanged) replace_in_two_steps(frames, folder);
}

}  // namespace

void write_frames(const fs::path& path, const motion::Animation& animation,
                  const OutputOptions& options) {
  const fs::path folder = output_path(path);
  recover(folder);
  std::optional<FolderLock> lock;
  if (fs::exists(folder)) {
    if (!fs::is_directory(folder)) cannot_write_frames(folder, "", ENOTDIR);
    lock.emplace(folder);
    check_holds_frames_only(folder, folder);
  }
  Temporary frames(folder, Temporary::Kind::folder);
  int number = 0;
  render_frames(animation, options, [&](const Raster& raster) {
    write_file(frames.path() / fmt::format("frame-{:04}.png", ++number),
               png(over(raster, options.background)));
  });
  if (lock) return replace(frames, folder);
  // Fails if another run has made the folder meanwhile.
  frames.keep();
}

}  // namespace wavecurve::io
