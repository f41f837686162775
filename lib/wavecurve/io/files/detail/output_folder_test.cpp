#include "wavecurve/io/files/detail/output_folder.hpp"

#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  static void write(const OutputFolder& output, const std::string& text) {
    fs::create_directories(output.staging() / "figures");
    for (const char* name : {"a.json", "b.html", "figures/c.svg"}) {
      write_file(output.staging() / name, text);
    }
  }
  static void expect_all(const fs::path& folder, const std::string& text) {
    for (const char* name : {"a.json", "b.html", "figures/c.svg"}) {
      EXPECT_EQ(read_file(folder / name), text) << name;
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 3);
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve output folder " + std::to_string(::getpid()));
};

TEST_F(OutputFolderTest, PutsAllFilesInTheirPlaces) {
  const fs::path folder = folder_ / "new" / "report";
  for (const char* text : {"first", "second"}) {
    OutputFolder output(folder);
    write(output, text);
    output.publish();
  }
  expect_all(folder, "second");
}

TEST_F(OutputFolderTest, UnpublishedIsAsIfItHadNeverBeen) {
  {
    OutputFolder output(folder_ / "new" / "report");
    write(output, "text");
  }
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

TEST_F(OutputFolderTest, AFailureWithinLeavesAllOldFiles) {
  {
    OutputFolder output(folder_);
    write(output, "old");
    output.publish();
  }
  {
    OutputFolder output(folder_);
    write(output, "new");
    // The last file to be put in its place cannot be: a folder stands there.
    write_file(output.staging() / "z", "new");
    fs::create_directory(folder_ / "z");
    EXPECT_THROW(output.publish(), std::system_error);
  }
  fs::remove(folder_ / "z");
  expect_all(folder_, "old");
}

TEST_F(OutputFolderTest, ALinkedFileIsWrittenThrough) {
  write_file(folder_ / "elsewhere", "old");
  fs::create_directory(folder_ / "report");
  fs::create_symlink("../elsewhere", folder_ / "report" / "a.json");
  OutputFolder output(folder_ / "report");
  write(output, "new");
  output.publish();
  EXPECT_TRUE(fs::is_symlink(folder_ / "report" / "a.json"));
  EXPECT_EQ(read_file(folder_ / "elsewhere"), "new");
}

TEST_F(OutputFolderTest, IsForOneRun) {
  const OutputFolder first(folder_);
  EXPECT_THROW(OutputFolder second(folder_), std::system_error);
  EXPECT_TRUE(fs::exists(first.staging()));
}

TEST_F(OutputFolderTest, APlaceThatIsNoFolderIsNamed) {
  write_file(folder_ / "file", "");
  for (const char* place : {"file", "file/b"}) {
    EXPECT_THROW(OutputFolder output(folder_ / place), std::system_error) << place;
  }
}

}  // namespace
}  // namespace wavecurve::io
