#include "wavecurve/io/files/write_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <utility>

#include "wavecurve/io/files/detail/open_file.hpp"
#include "wavecurve/io/files/detail/output_path.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"

namespace wavecurve::io {

namespace {

/// Collects pieces, so that the system is called once for many.
class Buffered {
 public:
  Buffered(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {}

  void add(std::string_view piece) {
    constexpr std::size_t enough = std::size_t{1} << 16;
    if (piece.size() < enough) bytes_ += piece;
    if (piece.size() >= enough || bytes_.size() >= enough) flush();
    if (piece.size() >= enough) write_all(descriptor_, piece, name_);
  }

  void flush() {
    write_all(descriptor_, bytes_, name_);
    bytes_.clear();
  }

 private:
  int descriptor_;
  std::string name_, bytes_;
};

void write_pieces(int descriptor, const std::string& name,
                  const std::function<void(const TextSink&)>& write) {
  Buffered buffered(descriptor, name);
  write([&](std::string_view piece) { buffered.add(piece); });
  buffered.flush();
}

void write_directly(const std::filesystem::path& path,
                    const std::function<void(const TextSink&)>& write) {
  const OpenFile descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor.is_open()) {
    throw std::system_error(errno, std::generic_category(), "cannot write " + path.string());
  }
  write_pieces(descriptor.number(), path.string(), write);
}

}  // namespace

void write_file(const std::filesystem::path& path,
                const std::function<void(const TextSink&)>& write) {
  if (is_special(path)) return write_directly(path, write);
  Temporary temporary(output_path(path), Temporary::Kind::file);
  write_pieces(temporary.descriptor(), path.string(), write);
  temporary.keep();
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  write_file(path, [&](const TextSink& sink) { sink(bytes); });
}

}  // namespace wavecurve::io
