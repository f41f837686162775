#include "wavecurve/io/animations/detail/write_video.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sched.h>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;

class WriteVideo : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "bin");
    fs::create_directories(folder_ / "out");
    options_.frames = 6;
    options_.pixels = 64;
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }
  /// A program that stands in for another one.
  void stand_in(const std::string& name, const std::string& script) const {
    std::ofstream(folder_ / "bin" / name) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(folder_ / "bin" / name, fs::perms::owner_all);
  }
  void write(const std::string& name) const {
    write_video(folder_ / "out" / name, sample_animation(), options_);
  }
  /// What is wrong with it; the old video is whole, and nothing lies beside it.
  std::string failure_of(const std::string& name) const {
    const fs::path video = folder_ / "out" / name;
    write_file(video, "the old one");
    std::string message;
    try {
      write(name);
    } catch (const std::exception& error) {
      message = error.what();
    }
    EXPECT_EQ(read_file(video), "the old one") << name;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 1) << name;
    fs::remove(video);
    return message;
  }

  const std::string path_ = std::getenv("PATH");
  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve write video " + std::to_string(::getpid()));
  OutputOptions options_;
};

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(WriteVideo, AnFfmpegThatDoesNotDoItsWorkIsFound) {
  // Complaints and exit code 0, as the true one has on a full disk.
  stand_in("ffmpeg", "cat >/dev/null; echo >&2; echo 'No space left' >&2");
  expect_part(failure_of("a.mp4"), "ffmpeg failed: No space left");
  stand_in("ffmpeg", "head -c 9 >/dev/null; kill -9 $$");
  expect_part(failure_of("a.webm"), "ffmpeg failed: it was ended by a signal");
  stand_in("ffmpeg", "cat >/dev/null; exit 7");
  expect_part(failure_of("a.gif"), "ffmpeg failed: exit code 7");
  stand_in("ffmpeg", "exit 0");
  EXPECT_NE(failure_of("a.gif"), "");
  stand_in("ffmpeg", "cat >/dev/null");
  EXPECT_NE(failure_of("a.mp4"), "") << "no video";
  stand_in("ffmpeg", "exec cat /dev/urandom >&2");
  expect_part(failure_of("a.mp4"), "prints more than");
}

TEST_F(WriteVideo, AVideoOfTooFewFramesIsRefused) {
  for (const std::string ending : {".gif", ".mp4", ".webm"}) {
    stand_in("ffmpeg",
             "export PATH='" + path_ + "'; { head -c 49920; cat >/dev/null; } | ffmpeg \"$@\"");
    expect_part(failure_of("a" + ending), "frames, not 6");
  }
}

TEST_F(WriteVideo, ATruncatedVideoIsRefused) {
  options_.frames = 60;
  for (const std::string ending : {".gif", ".mp4", ".webm"}) {
    stand_in("ffmpeg",
             "export PATH='" + path_ +
                 "'; ffmpeg \"$@\"; for file; do :; done; file=${file#file:}; "
                 "size=$(stat -L -c %s \"$file\"); truncate -s $((size * 2 / 3)) \"$file\"");
    expect_part(failure_of("a" + ending), "cannot write ");
  }
}

TEST_F(WriteVideo, AMissingProgramIsNamed) {
  ::setenv("PATH", (folder_ / "bin").c_str(), 1);
  expect_part(failure_of("a.mp4"), "cannot run ffmpeg");
  stand_in("ffmpeg", "export PATH='" + path_ + "'; ffmpeg \"$@\"");
  expect_part(failure_of("a.mp4"), "cannot run ffprobe");
}

TEST_F(WriteVideo, TakesNamesThatFfmpegWouldMistake) {
  const fs::path here = fs::current_path();
  fs::current_path(folder_ / "out");
  for (const std::string folder : {"-y", "http:"}) {
    fs::create_directory(folder);
    write_video(folder + "/a.gif", sample_animation(), options_);
    EXPECT_GT(fs::file_size(folder + "/a.gif"), 500U);
  }
  fs::current_path(here);
}

TEST_F(WriteVideo, HasTheSameBytesOnOneProcessorAndOnAll) {
  cpu_set_t all, one;
  ASSERT_EQ(::sched_getaffinity(0, sizeof all, &all), 0);
  if (CPU_COUNT(&all) == 1) GTEST_SKIP() << "there is but one processor";
  CPU_ZERO(&one);
  for (std::size_t i = 0; CPU_COUNT(&one) == 0; ++i) {
    if (CPU_ISSET(i, &all)) CPU_SET(i, &one);
  }
  options_.frames = 40;
  options_.pixels = 256;  // VP9 divides only what is wide enough
  for (const std::string ending : {".gif", ".mp4", ".webm"}) {
    write("all" + ending);
    ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
    write("one" + ending);
    ASSERT_EQ(::sched_setaffinity(0, sizeof all, &all), 0);
    EXPECT_EQ(read_file(folder_ / "out" / ("all" + ending)),
              read_file(folder_ / "out" / ("one" + ending)))
        << ending;
  }
}

}  // namespace
}  // namespace wavecurve::io
