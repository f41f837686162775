#include "wavecurve/io/files/detail/output_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "wavecurve/io/files/detail/output_path.hpp"
#include "wavecurve/io/files/detail/unfinished.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* folder_of_old_files = ".old";

[[noreturn]] void cannot_publish(const fs::path& path, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write " + path.string());
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  }
  std::ranges::sort(files, {}, [](const fs::path& file) {
    return std::pair(!file.has_parent_path(), file.string());
  });
  return files;
}

void sync(const fs::path& path) {
  const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open() || ::fsync(file.number()) != 0) cannot_publish(path, errno);
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) : folder_(output_path(folder)) {
  try {
    make_folders(folder_);
    lock_.emplace(folder_);
    staging_.emplace(folder_ / "staging", Temporary::Kind::folder);
  } catch (...) {
    remove_made_folders();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  staging_.reset();
  remove_made_folders();
}

void OutputFolder::make_folders(const fs::path& folder) {
  if (folder.empty() || fs::is_directory(folder)) return;
  make_folders(output_path(folder).parent_path());
  std::error_code error;
  if (fs::create_directory(folder, error)) made_folders_.push_back(folder);
  if (error) throw std::system_error(error, "cannot make the folder " + folder_.string());
}

void OutputFolder::publish() {
  const std::vector<fs::path> files = files_in(staging());
  for (const fs::path& file : files) sync(staging() / file);
  fs::create_directory(staging() / folder_of_old_files);
  const Unfinished all_or_nothing;
  try {
    for (const fs::path& file : files) put_in_place(file);
    steps_.clear();
  } catch (...) {
    undo();
    throw;
  }
}

void OutputFolder::put_in_place(const fs::path& file) {
  const fs::path made = staging() / file;
  Step step{output_path(folder_ / file), {}, false};
  make_folders(step.target.parent_path());
  struct stat status {};
  if (::stat(step.target.c_str(), &status) == 0) {
    step.replaces = true;
    step.old = staging() / folder_of_old_files / std::to_string(steps_.size());
    if (::link(step.target.c_str(), step.old.c_str()) != 0) step.old.clear();
    if (::chmod(made.c_str(), status.st_mode & 07777) != 0) cannot_publish(step.target, errno);
  }
  if (::rename(made.c_str(), step.target.c_str()) != 0) cannot_publish(step.target, errno);
  steps_.push_back(step);
}

void OutputFolder::undo() {
  std::error_code ignored;
  for (; !steps_.empty(); steps_.pop_back()) {
    const Step& step = steps_.back();
    if (!step.old.empty()) fs::rename(step.old, step.target, ignored);
    if (!step.replaces) fs::remove(step.target, ignored);
  }
}

/// No more than empty ones.
void OutputFolder::remove_made_folders() {
  std::error_code ignored;
  for (; !made_folders_.empty(); made_folders_.pop_back()) {
    fs::remove(made_folders_.back(), ignored);
  }
}

}  // namespace wavecurve::io
