#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

#include "wavecurve/io/files/detail/open_file.hpp"

struct pollfd;

namespace wavecurve::io {

struct ChildSetting {
  bool has_input = false;                   ///< it reads what we write; else nothing
  std::filesystem::path directory = {};     ///< where it stands; where we stand if this is empty
  std::vector<std::string> variables = {};  ///< NAME=VALUE, beside our environment
  /// An open file that it finds as /dev/fd/3. What it is given by name, it may make again after we
  /// were killed and a later run has removed it.
  const OpenFile* file = nullptr;
};

/// A running program, found through PATH, that leads a process group of its own. It speaks no
/// language but C. It is killed, with all that it started, if this is gone before finish(), or when
/// the program is told to end (Unfinished).
class ChildProcess {
 public:
  /// More than this is refused, of both streams: a program that prints without end must not fill the
  /// memory.
  static constexpr std::size_t most_output = std::size_t{64} << 20;

  /// Throws std::system_error if it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command, const ChildSetting& setting = {});
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// Hands bytes over, and takes what it prints meanwhile, so that neither waits for the other for
  /// ever. False if it reads no more.
  bool write(std::string_view bytes);

  /// Ends its input, takes all that it prints, and waits for its end. Its exit code, or -1 if it was
  /// ended by a signal.
  int finish();

  const std::string& out() const { return out_text_; }
  const std::string& err() const { return err_text_; }

 private:
  void start(std::vector<std::string> command, const ChildSetting& setting, OpenFile input,
             OpenFile out, OpenFile err);
  std::size_t exchange(std::string_view bytes);
  void take(OpenFile& stream, const pollfd& state, std::string& text);
  int wait();

  std::string name_;
  pid_t process_ = 0;
  OpenFile input_, out_, err_;
  std::string out_text_, err_text_;
};

}  // namespace wavecurve::io
