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

#include "wavecurve/filters/detail/bad_value.hpp"
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

bool is_transparent(const OutputOptions& options) {
  return options.transparent && !options.background;
}

/// Gives pixels that do not show the colour of the one before them in their row, or after: what a
/// codec mixes at an edge is then the edge's own colour, not black.
void spread_colours(Raster& raster) {
  const auto pixels = static_cast<std::ptrdiff_t>(raster.width);
  for (int y = 0; y < raster.height; ++y) {
    std::uint8_t* row = raster.rgba.data() + 4 * pixels * y;
    const auto copy = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
      if (row[4 * to + 3] == 0) std::copy_n(row + 4 * from, 3, row + 4 * to);
    };
    for (std::ptrdiff_t x = pixels - 1; x > 0; --x) copy(x, x - 1);
    for (std::ptrdiff_t x = 1; x < pixels; ++x) copy(x - 1, x);
  }
}

/// What ffmpeg is to do with the frames; repeatable to the byte, for it divides the work among
/// threads nowhere.
std::vector<std::string> encoding(const std::string& ending, const OutputOptions& options) {
  if (ending == ".gif") {
    return {"-vf",   "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
            "-loop", options.loop ? "0" : "-1",
            "-f",    "gif"};
  }
  if (ending == ".webm" && is_transparent(options)) {
    return {"-c:v", "libvpx-vp9", "-pix_fmt", "yuva420p", "-auto-alt-ref", "0", "-crf",
            "24",   "-b:v",       "0",        "-f",       "webm"};
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

/// The bytes of a frame: rgba where it is transparent, else rgb.
std::string frame_bytes(Raster raster, const OutputOptions& options) {
  std::string bytes;
  if (is_transparent(options)) {
    spread_colours(raster);
    return {raster.rgba.begin(), raster.rgba.end()};
  }
  raster = over(std::move(raster), options.background.value_or(Colour{1, 1, 1}));
  bytes.reserve(raster.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < raster.rgba.size(); ++i) {
    if (i % 4 != 3) bytes += static_cast<char>(raster.rgba[i]);
  }
  return bytes;
}

/// What the formats do not have.
void check_format(const std::string& ending, RasterSize size, double rate,
                  const OutputOptions& options) {
  if (ending == ".mp4" && is_transparent(options)) {
    throw std::invalid_argument("an .mp4 has no transparency: it needs a background");
  }
  if (ending != ".gif" && (size.width % 2 != 0 || size.height % 2 != 0)) {
    throw std::invalid_argument(must_be("the size of an " + ending,
                                        fmt::format("{}x{}", size.width, size.height),
                                        "two even numbers"));
  }
  if (ending == ".gif" && rate > 100) {
    throw std::invalid_argument(must_be("the rate of a .gif", rate, "at most 100 frames a second"));
  }
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
                                 is_transparent(options) ? "rgba" : "rgb24",
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
    if (ffmpeg->write(frame_bytes(raster, options))) return;
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
  const RasterSize size = raster_size(animation.view_box, options);
  const double rate = (options.frames - 1) / animation.duration;
  check_format(path.extension().string(), size, rate, options);
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
