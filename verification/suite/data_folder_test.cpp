#include "verification/suite/data_folder.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

namespace fs = std::filesystem;

class DataFolder : public testing::Test {
 protected:
  void SetUp() override {
    for (const fs::path& file : data_files()) {
      const fs::path path = prefix / "share/wavecurve" / file;
      fs::create_directories(path.parent_path());
      std::ofstream(path) << "";
    }
  }
  void TearDown() override { fs::remove_all(prefix); }

  const fs::path prefix =
      fs::temp_directory_path() / ("wavecurve_data_" + std::to_string(::getpid()));
};

TEST_F(DataFolder, IsTheSourceTreesForTheTests) {
  EXPECT_TRUE(fs::is_regular_file(data_folder() / "published" / "table_1.csv"));
  EXPECT_TRUE(fs::is_regular_file(data_folder() / "examples" / "three.svg"));
  EXPECT_TRUE(fs::is_regular_file(data_folder() / "reference" / "verdicts.json"));
  EXPECT_TRUE(fs::equivalent(data_folder() / "examples", source_tree() / "docs" / "examples"));
}

TEST_F(DataFolder, StandsBesideAnInstalledProgram) {
  EXPECT_EQ(data_folder_of(prefix / "bin" / "wavecurve"), prefix / "share" / "wavecurve");
  EXPECT_TRUE(source_tree_of(prefix / "bin" / "wavecurve").empty());
}

TEST_F(DataFolder, IsWhatALibraryInAnothersProgramSays) {
  const fs::path before = data_folder();
  use_data_folder(prefix / "share/wavecurve");
  EXPECT_EQ(data_folder(), prefix / "share/wavecurve");
  EXPECT_THROW(use_data_folder(prefix), std::system_error);
  EXPECT_EQ(data_folder(), prefix / "share/wavecurve");
  use_data_folder(before);
  EXPECT_EQ(data_folder(), before);
}

TEST_F(DataFolder, NamesThePlaceWhereNoDataAre) {
  try {
    data_folder_of(prefix / "elsewhere" / "bin" / "wavecurve");
    FAIL() << "nothing is there";
  } catch (const std::system_error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find((prefix / "elsewhere/share/wavecurve").string()), std::string::npos)
        << what;
  }
}

TEST_F(DataFolder, WithoutOneOfItsFilesIsRefused) {
  const auto& files = data_files();
  EXPECT_NE(std::ranges::find(files, "published/taps_coiflets.csv"), files.end());
  EXPECT_NE(std::ranges::find(files, "examples/dog-walk.csv"), files.end());
  for (const fs::path& file : {files.front(), files.back()}) {
    fs::rename(prefix / "share/wavecurve" / file, prefix / "aside");
    try {
      data_folder_of(prefix / "bin" / "wavecurve");
      ADD_FAILURE() << file << " is not missed";
    } catch (const std::system_error& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
    }
    fs::rename(prefix / "aside", prefix / "share/wavecurve" / file);
  }
}

TEST_F(DataFolder, KnowsNoSourcesInAMovedBuildTree) {
  fs::create_directory_symlink(prefix / "gone", prefix / "share/wavecurve/source");
  EXPECT_TRUE(source_tree_of(prefix / "bin" / "wavecurve").empty());
}

}  // namespace
}  // namespace wavecurve::verification
