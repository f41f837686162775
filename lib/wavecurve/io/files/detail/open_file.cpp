#include "wavecurve/io/files/detail/open_file.hpp"

#include <cerrno>
#include <system_error>
#include <unistd.h>

namespace wavecurve::io {

void OpenFile::close() {
  // What is to last was synced before, so that an error of closing tells nothing new.
  if (is_open()) ::close(std::exchange(number_, -1));
}

void write_all(int descriptor, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw std::system_error(errno, std::generic_category(), "cannot write " + name);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace wavecurve::io
