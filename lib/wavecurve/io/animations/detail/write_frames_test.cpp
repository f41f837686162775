#include "wavecurve/io/animations/detail/write_frames.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;

class WriteFrames : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    options_.pixels = 16;
    options_.frames = 3;
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const fs::path& path) const { write_frames(path, sample_animation(), options_); }
  std::set<std::string> names(const fs::path& path) const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(path)) all.insert(entry.path().filename());
    return all;
  }
  void expect_refused(const fs::path& path, const std::string& part) const {
    const auto before = names(path);
    try {
      write(path);
      ADD_FAILURE() << part;
    } catch (const std::system_error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(names(path), before) << part;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve write frames " + std::to_string(::getpid()));
  OutputOptions options_;
};

TEST_F(WriteFrames, ReplacesOldFramesAndNothingElse) {
  const fs::path path = folder_ / "a.png";
  write(path);
  options_.frames = 2;
  write(path);
  EXPECT_EQ(names(path), (std::set<std::string>{"frame-0001.png", "frame-0002.png"}));
  fs::create_directories(path / "frame-0009.png");
  write_file(path / "frame-0009.png" / "letter", "kept");
  expect_refused(path, "it holds frame-0009.png, which is no frame of ours");
  EXPECT_EQ(read_file(path / "frame-0009.png" / "letter"), "kept");
  fs::remove_all(path / "frame-0009.png");
  for (const char* foreign : {"frame-9.png", "frame-00010.png", "frame-.png", "frame-00a1.png",
                              "frame-0001.png~", "Frame-0001.png", ".hidden"}) {
    write_file(path / foreign, "");
    expect_refused(path, foreign);
    fs::remove(path / foreign);
  }
  fs::create_symlink("frame-0001.png", path / "frame-0004.png");
  expect_refused(path, "frame-0004.png");
  EXPECT_EQ(names(folder_), std::set<std::string>{"a.png"});
}

TEST_F(WriteFrames, ALinkToAFolderIsFollowed) {
  fs::create_directory_symlink("b", folder_ / "a.png");
  write(folder_ / "a.png");  // to a folder that is not there yet
  write(folder_ / "a.png");
  write(folder_ / "a.png" / "");
  EXPECT_TRUE(fs::is_symlink(folder_ / "a.png"));
  EXPECT_EQ(names(folder_ / "b").size(), 3U);
  EXPECT_EQ(names(folder_), (std::set<std::string>{"a.png", "b"}));
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THROW(write(folder_ / "loop"), std::system_error);
}

TEST_F(WriteFrames, WhatARunThatDiedHadPutAsideIsPutBack) {
  const fs::path path = folder_ / "a.png", aside = folder_ / "a.png.wavecurve-old";
  write(path);
  fs::rename(path, aside);  // as a run that died between two renames leaves it
  options_.frames = 0;      // so that this run fails
  EXPECT_THROW(write(path), std::invalid_argument);
  EXPECT_EQ(names(path).size(), 3U);
  options_.frames = 2;
  fs::copy(path, aside);  // as a run that died after both leaves it
  write(path);
  EXPECT_EQ(names(path).size(), 2U);
  EXPECT_EQ(names(folder_), std::set<std::string>{"a.png"});
  fs::create_directory(aside);
  write_file(aside / "letter", "kept");
  EXPECT_THROW(write(path), std::system_error);
  EXPECT_EQ(read_file(aside / "letter"), "kept");
}

TEST_F(WriteFrames, TheSecondOfTwoRunsIsRefused) {
  write(folder_ / "a.png");
  const FolderLock other_run(folder_ / "a.png");
  expect_refused(folder_ / "a.png", "another run is writing to");
}

TEST_F(WriteFrames, AFolderThatAnotherRunMadeMeanwhileIsKept) {
  const fs::path path = folder_ / "a.png";
  options_.progress = [&](int done, int) {
    if (done != 2) return;
    fs::create_directory(path);
    write_file(path / "frame-0001.png", "of another run");
  };
  EXPECT_THROW(write(path), std::system_error);
  EXPECT_EQ(read_file(path / "frame-0001.png"), "of another run");
  EXPECT_EQ(names(folder_), std::set<std::string>{"a.png"});
}

TEST_F(WriteFrames, WhatCameIntoTheFolderMeanwhileIsKept) {
  const fs::path path = folder_ / "a.png";
  write(path);
  options_.progress = [&](int done, int) {
    if (done == 2) write_file(path / "letter", "kept");
  };
  EXPECT_THROW(write(path), std::system_error);
  EXPECT_EQ(read_file(path / "letter"), "kept");
  EXPECT_EQ(names(path).size(), 4U);
}

}  // namespace
}  // namespace wavecurve::io
