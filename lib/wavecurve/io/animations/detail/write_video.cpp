#include "wavecurve/io/animations/detail/write_video.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/render_frames.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

extern char** environ;

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write_video(int error, const std::string& message) {
  throw std::system_error(error, std::generic_category(), message);
}

/// A folder for the program's files, gone when this is.
class TemporaryFolder {
 public:
  TemporaryFolder() : name_((fs::temp_directory_path() / "wavecurve-video-XXXXXX").string()) {
    if (::mkdtemp(name_.data()) == nullptr)
      cannot_write_video(errno, "cannot make a folder " + name_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(name_, ignored);
  }
  fs::path operator/(const char* name) const { return fs::path(name_) / name; }

 private:
  std::string name_;
};

/// A running ffmpeg that reads its input from us. A socket instead of a pipe, for writing to one
/// whose reader has died can be told not to raise a signal.
class Ffmpeg {
 public:
  Ffmpeg(std::vector<std::string> arguments, const fs::path& complaints) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      cannot_write_video(errno, "cannot make a socket for ffmpeg");
    }
    input_ = ends[0];
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, complaints.c_str(),
                                       O_WRONLY | O_CREAT, 0600);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int error = ::posix_spawnp(&process_, argv[0], &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (error != 0) {
      ::close(input_);
      cannot_write_video(error, "cannot run ffmpeg, which .gif, .mp4 and .webm need");
    }
  }
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;
  /// Without finish(), what is under way is given up.
  ~Ffmpeg() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    finish();
  }

  /// False if the program reads no more.
  bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  /// Ends the input and waits. True if all went well.
  bool finish() {
    ::close(input_);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  pid_t process_ = 0;
  int input_ = -1;
};

/// What ffmpeg is to do with the frames; repeatable to the byte.
std::vector<std::string> encoding(const std::string& ending, const OutputOptions& options) {
  if (ending == ".gif") {
    return {"-vf",   "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
            "-loop", options.loop ? "0" : "-1",
            "-f",    "gif"};
  }
  if (ending == ".mp4") {
    return {"-c:v", "libx264",   "-pix_fmt",   "yuv420p", "-crf",
            "18",   "-movflags", "+faststart", "-f",      "mp4"};
  }
  if (ending == ".webm") {
    return {"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "24", "-b:v", "0", "-f", "webm"};
  }
  throw std::invalid_argument("no video format has the ending of " + ending);
}

std::string over_background(const Raster& raster, const Colour& background) {
  const double channels[3] = {background.red, background.green, background.blue};
  std::string rgb;
  rgb.reserve(raster.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < raster.rgba.size(); i += 4) {
    const double alpha = raster.rgba[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = alpha * raster.rgba[i + c] + (1 - alpha) * 255 * channels[c];
      rgb += static_cast<char>(static_cast<unsigned char>(value + 0.5));
    }
  }
  return rgb;
}

std::string first_line(const fs::path& file) {
  const std::string text = read_file(file);
  return text.substr(0, text.find('\n'));
}

}  // namespace

void write_video(const fs::path& path, const motion::Animation& animation,
                 const OutputOptions& options) {
  motion::check_animation(animation);
  const RasterSize size = raster_size(animation.view_box, options.pixels);
  const TemporaryFolder folder;
  std::vector<std::string> arguments{
      "ffmpeg",
      "-nostdin",
      "-loglevel",
      "error",
      "-f",
      "rawvideo",
      "-pix_fmt",
      "rgb24",
      "-video_size",
      fmt::format("{}x{}", size.width, size.height),
      "-framerate",
      fmt::format("{:.6f}", (options.frames - 1) / animation.duration),
      "-i",
      "pipe:0",
      "-fflags",
      "+bitexact",
      "-flags:v",
      "+bitexact",
      "-map_metadata",
      "-1"};
  for (const std::string& word : encoding(path.extension().string(), options)) {
    arguments.push_back(word);
  }
  arguments.push_back((folder / "video").string());
  Ffmpeg ffmpeg(arguments, folder / "complaints");
  render_frames(animation, options, [&](const Raster& raster) {
    // Its complaint is more telling than that it reads no more, and is looked at below.
    ffmpeg.write(over_background(raster, options.background));
  });
  if (!ffmpeg.finish())
    cannot_write_video(EIO, "ffmpeg failed: " + first_line(folder / "complaints"));
  constexpr std::size_t as_it_is = std::numeric_limits<std::size_t>::max() - 1;
  write_file(path, read_file(folder / "video", as_it_is));
}

}  // namespace wavecurve::io
