#include "wavecurve/io/animations/detail/write_video.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/io/animations/detail/render_frames.hpp"
#include "wavecurve/io/files/detail/child_process.hpp"
#include "wavecurve/io/files/detail/output_path.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"
#include "wavecurve/motion/detail/check_animation.hpp"

namespace wavecurve::io {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write_video(int error, const std::string& message) {
  throw std::system_error(error, std::generic_category(), message);
}

/// What ffmpeg is to do with the frames; repeatable to the byte, for it divides the work among
/// threads nowhere.
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

std::vector<std::string> encoder(const std::string& ending, RasterSize size, double rate,
                                 const OutputOptions& options) {
  std::vector<std::string> words{"ffmpeg",
                                 "-nostdin",
                                 "-y",
                                 "-loglevel",
                                 "error",
                                 "-f",
                                 "rawvideo",
                                 "-pix_fmt",
                                 "rgb24",
                                 "-video_size",
                                 fmt::format("{}x{}", size.width, size.height),
                                 "-framerate",
                                 fmt::format("{:.6f}", rate),
                                 "-i",
                                 "pipe:0",
                                 "-threads",
                                 "1",
                                 "-filter_threads",
                                 "1",
                                 "-fflags",
                                 "+bitexact",
                                 "-flags:v",
                                 "+bitexact",
                                 "-map_metadata",
                                 "-1"};
  for (std::string& word : encoding(ending, options)) words.push_back(std::move(word));
  words.emplace_back("file:/dev/fd/3");
  return words;
}

/// The first line of what a program says that is not empty, cut off where it gets long.
std::string first_complaint_of(const ChildProcess& program, int exit_code) {
  constexpr std::size_t longest = 300;
  const std::string& text = program.err();
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos) {
    return exit_code < 0 ? "it was ended by a signal" : fmt::format("exit code {}", exit_code);
  }
  return text.substr(start, std::min(text.find_first_of("\r\n", start) - start, longest));
}

/// ffmpeg ends with exit code 0 after some failures to write, but never without a message.
void finish(ChildProcess& program, const char* name, const fs::path& path) {
  const int exit_code = program.finish();
  if (exit_code == 0 && program.err().empty()) return;
  cannot_write_video(EIO, fmt::format("cannot write {}: {} failed: {}", path.string(), name,
                                      first_complaint_of(program, exit_code)));
}

void encode(const std::vector<std::string>& command, const fs::path& video,
            const motion::Animation& animation, const OutputOptions& options,
            const fs::path& path) {
  // Opened anew: with our own descriptor ffmpeg would have the lock too, and might survive us.
  const OpenFile file(::open(video.c_str(), O_RDWR | O_CLOEXEC));
  if (!file.is_open()) cannot_write_video(errno, "cannot write " + path.string());
  std::optional<ChildProcess> ffmpeg;
  try {
    ffmpeg.emplace(command, ChildSetting{.has_input = true, .file = &file});
  } catch (const std::system_error& error) {
    throw std::system_error(error.code(), "cannot run ffmpeg, which .gif, .mp4 and .webm need");
  }
  render_frames(animation, options, [&](const Raster& raster) {
    if (ffmpeg->write(over_background(raster, options.background))) return;
    finish(*ffmpeg, "ffmpeg", path);
    cannot_write_video(EIO, "cannot write " + path.string() + ": ffmpeg does not read all frames");
  });
  finish(*ffmpeg, "ffmpeg", path);
}

/// Decodes the video, every frame of it.
void check_video(const fs::path& video, int frames, const fs::path& path) try {
  ChildProcess ffprobe(
      {"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
       "stream=nb_read_frames", "-of", "csv=p=0",
       "file:" + video.string()});  // a name may hold a colon, or begin with a dash
  finish(ffprobe, "ffprobe", path);
  const std::string count = ffprobe.out().substr(0, ffprobe.out().find_first_of(",\r\n"));
  if (count == std::to_string(frames)) return;
  cannot_write_video(EIO, fmt::format("cannot write {}: what ffmpeg wrote has {} frames, not {}",
                                      path.string(), count.empty() ? "no" : count, frames));
} catch (const std::system_error& error) {
  if (error.code() != std::errc::no_such_file_or_directory) throw;
  throw std::system_error(error.code(), "cannot run ffprobe (a part of ffmpeg)");
}

/// To a pipe or a device, which cannot be replaced.
void copy_video(const Temporary& video, const fs::path& path) {
  const OpenFile target(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!target.is_open()) cannot_write_video(errno, "cannot write " + path.string());
  std::vector<char> part(std::size_t{1} << 20);
  for (off_t place = 0;;) {
    const ssize_t count = ::pread(video.descriptor(), part.data(), part.size(), place);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannot_write_video(errno, "cannot read the video");
    if (count == 0) return;
    write_all(target.number(), {part.data(), static_cast<std::size_t>(count)}, path.string());
    place += count;
  }
}

}  // namespace

void write_video(const fs::path& path, const motion::Animation& animation,
                 const OutputOptions& options) {
  motion::check_animation(animation);
  const RasterSize size = raster_size(animation.view_box, options.pixels);
  const double rate = (options.frames - 1) / animation.duration;
  // Nothing can be made beside a pipe or a device.
  const bool special = is_special(path);
  Temporary video(special ? fs::temp_directory_path() / "video" : output_path(path),
                  Temporary::Kind::file);
  encode(encoder(path.extension().string(), size, rate, options), video.path(), animation, options,
         path);
  check_video(video.path(), options.frames, path);
  if (special) return copy_video(video, path);
  video.keep();
}

}  // namespace wavecurve::io
