#include "verification/suite/data_folder.hpp"

#include <system_error>

namespace wavecurve::verification {

namespace fs = std::filesystem;

namespace {

fs::path folder_beside(const fs::path& program) {
  return program.parent_path().parent_path() / "share" / "wavecurve";
}

fs::path running_program() { return fs::read_symlink("/proc/self/exe"); }

/// The folder, if all data are there.
fs::path complete(const fs::path& folder) {
  std::error_code no_folder;
  if (!fs::is_directory(folder, no_folder)) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                            "cannot find the program's data in " + folder.string());
  }
  for (const fs::path& file : data_files()) {
    std::error_code error;
    if (fs::is_regular_file(folder / file, error)) continue;
    if (!error) error = std::make_error_code(std::errc::no_such_file_or_directory);
    throw std::system_error(error,
                            "the program's data are not complete: " + (folder / file).string());
  }
  return folder;
}

/// Empty: that of the running program.
fs::path& chosen_folder() {
  static fs::path folder;
  return folder;
}

}  // namespace

fs::path source_tree_of(const fs::path& program) {
  // A link that CMake makes, and that is never installed.
  const fs::path link = folder_beside(program) / "source";
  std::error_code error;
  return fs::is_directory(link, error) ? fs::read_symlink(link) : fs::path();
}

fs::path data_folder_of(const fs::path& program) { return complete(folder_beside(program)); }

fs::path data_folder() {
  return chosen_folder().empty() ? data_folder_of(running_program()) : complete(chosen_folder());
}

void use_data_folder(const fs::path& folder) { chosen_folder() = complete(folder); }

fs::path source_tree() { return source_tree_of(running_program()); }

}  // namespace wavecurve::verification
