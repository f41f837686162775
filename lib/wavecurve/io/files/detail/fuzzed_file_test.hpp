#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sys/mman.h>
#include <unistd.h>

namespace wavecurve::io {

/// Bytes as a file, for readers that take a path: it is in memory, and gone with the object.
class FuzzedFile {
 public:
  FuzzedFile(const std::uint8_t* bytes, std::size_t size)
      : descriptor_(::memfd_create("fuzzed.json", MFD_CLOEXEC)) {
    if (descriptor_ < 0 || ::write(descriptor_, bytes, size) != static_cast<ssize_t>(size)) {
      std::abort();
    }
  }
  ~FuzzedFile() { ::close(descriptor_); }
  FuzzedFile(const FuzzedFile&) = delete;
  FuzzedFile& operator=(const FuzzedFile&) = delete;

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace wavecurve::io
