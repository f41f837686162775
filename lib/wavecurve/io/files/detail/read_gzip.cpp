#include "wavecurve/io/files/detail/read_gzip.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <zlib.h>

#include "wavecurve/io/files/detail/cannot_open.hpp"

namespace wavecurve::io {

namespace {

constexpr std::size_t largest_step = std::size_t{1} << 20;

struct Close {
  void operator()(gzFile file) const { gzclose(file); }
};

}  // namespace

std::string read_gzip(const std::filesystem::path& path, std::size_t bound) {
  const auto refuse = [&](const std::string& reason) {
    throw std::invalid_argument("cannot read " + path.string() + ": " + reason);
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("it is a directory");
  errno = 0;
  const std::unique_ptr<gzFile_s, Close> file(gzopen(path.c_str(), "rb"));
  if (!file) cannot_open(path, errno);
  std::string bytes;
  int got = 1;
  while (got > 0 && bytes.size() <= bound) {
    const std::size_t size = bytes.size(), step = std::min(bound + 1 - size, largest_step);
    bytes.resize(size + step);
    got = gzread(file.get(), bytes.data() + size, static_cast<unsigned>(step));
    bytes.resize(size + static_cast<std::size_t>(std::max(got, 0)));
  }
  int error = Z_OK;
  gzerror(file.get(), &error);
  if (error == Z_ERRNO) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + path.string());
  }
  if (error == Z_MEM_ERROR) throw std::bad_alloc();
  if (error == Z_BUF_ERROR) refuse("it ends too early");
  if (error != Z_OK && error != Z_STREAM_END) refuse("its gzip data are damaged");
  return bytes;
}

}  // namespace wavecurve::io
