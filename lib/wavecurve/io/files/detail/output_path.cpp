#include "wavecurve/io/files/detail/output_path.hpp"

#include <cerrno>
#include <string>
#include <system_error>

namespace wavecurve::io {

namespace fs = std::filesystem;

fs::path output_path(const fs::path& path) {
  constexpr int most_links = 40;  // as Linux has it
  fs::path target = path.has_filename() ? path : path.parent_path();
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    if (links == most_links) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    if (links < most_links) target = target.parent_path() / fs::read_symlink(target, error);
    if (error) throw std::system_error(error, "cannot write " + path.string());
  }
  return target;
}

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace wavecurve::io
