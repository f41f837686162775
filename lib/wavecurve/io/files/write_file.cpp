#include "wavecurve/io/files/write_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <system_error>

#include "wavecurve/io/files/detail/open_file.hpp"
#include "wavecurve/io/files/detail/output_path.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"

namespace wavecurve::io {

namespace {

void write_directly(const std::filesystem::path& path, std::string_view bytes) {
  const OpenFile descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor.is_open()) {
    throw std::system_error(errno, std::generic_category(), "cannot write " + path.string());
  }
  write_all(descriptor.number(), bytes, path.string());
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  if (is_special(path)) return write_directly(path, bytes);
  Temporary temporary(output_path(path), Temporary::Kind::file);
  write_all(temporary.descriptor(), bytes, path.string());
  temporary.keep();
}

}  // namespace wavecurve::io
