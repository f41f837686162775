#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace wavecurve::io {

/// A number by which the system knows an open file; closed when this is gone.
class OpenFile {
 public:
  OpenFile() = default;
  explicit OpenFile(int number) : number_(number) {}
  OpenFile(OpenFile&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~OpenFile() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close();

 private:
  int number_ = -1;
};

/// Writes all bytes, in as many calls as it takes. Throws std::system_error that says that `name`
/// cannot be written.
void write_all(int descriptor, std::string_view bytes, const std::string& name);

}  // namespace wavecurve::io
