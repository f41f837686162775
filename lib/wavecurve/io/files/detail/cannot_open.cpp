#include "wavecurve/io/files/detail/cannot_open.hpp"

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace wavecurve::io {

void cannot_open(const std::filesystem::path& path, int error) {
  static constexpr int of_the_machine[] = {EMFILE, ENFILE, ENOMEM, ENOSPC, EDQUOT,
                                           EIO,    ESTALE, EROFS,  EINTR,  ENODEV};
  const std::string what = "cannot read " + path.string();
  if (std::ranges::find(of_the_machine, error) != std::end(of_the_machine)) {
    throw std::system_error(error, std::generic_category(), what);
  }
  throw std::invalid_argument(what + ": " + std::generic_category().message(error));
}

}  // namespace wavecurve::io
