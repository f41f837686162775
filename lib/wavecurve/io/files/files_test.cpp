#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  fs::path folder_ =
      fs::temp_directory_path() /
      ("wavecurve-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
       std::to_string(::getpid()));
};

TEST_F(Files, WriteReplacesTheWholeFileAndLeavesNothingBeside) {
  const fs::path path = folder_ / "a.txt";
  write_file(path, "first, and long");
  write_file(path, std::string("se\0cond", 7));
  EXPECT_EQ(read_file(path), std::string("se\0cond", 7));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, AFailedWriteKeepsTheOldFile) {
  const fs::path path = folder_ / "missing" / "a.txt";
  EXPECT_THROW(write_file(path, "x"), std::system_error);
  EXPECT_THROW(write_file(folder_, "x"), std::system_error);
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Files, AFullDeviceIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  try {
    write_file("/dev/full", "x");
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOSPC);
  }
}

TEST_F(Files, AWriteThroughALinkKeepsTheLink) {
  write_file(folder_ / "target", "old");
  fs::create_symlink(folder_ / "target", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "target"), "new");
}

TEST_F(Files, ALinkToNothingIsCreatedThrough) {
  fs::create_directory(folder_ / "there");
  fs::create_symlink("there/file", folder_ / "inner");
  fs::create_symlink(folder_ / "inner", folder_ / "outer");
  write_file(folder_ / "outer", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "outer"));
  EXPECT_EQ(read_file(folder_ / "there" / "file"), "new");
  fs::create_symlink("nowhere/file", folder_ / "lost");
  EXPECT_THROW(write_file(folder_ / "lost", "x"), std::system_error);
}

TEST_F(Files, ACircleOfLinksIsBadInputAndNoOutput) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  EXPECT_THROW(read_file(folder_ / "a"), std::invalid_argument);
  EXPECT_THROW(write_file(folder_ / "a", "x"), std::system_error);
  EXPECT_THROW(read_file(folder_ / std::string(300, 'n')), std::invalid_argument);
}

TEST_F(Files, ReadNamesWhatItCannotRead) {
  EXPECT_THROW(read_file(folder_ / "nothing"), std::invalid_argument);
  EXPECT_THROW(read_file(folder_), std::invalid_argument);
}

TEST_F(Files, ReadRefusesWhatIsLargerThanItsBound) {
  write_file(folder_ / "ten", "0123456789");
  EXPECT_EQ(read_file(folder_ / "ten", 10).size(), 10U);
  try {
    read_file(folder_ / "ten", 9);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(),
              "cannot read " + (folder_ / "ten").string() + ": it is larger than 9 bytes");
  }
  // A device has no size beforehand, and no end.
  if (fs::exists("/dev/zero")) {
    EXPECT_THROW(read_file("/dev/zero", 1000), std::invalid_argument);
  }
}

}  // namespace
}  // namespace wavecurve::io
