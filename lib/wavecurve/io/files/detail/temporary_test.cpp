#include "wavecurve/io/files/detail/temporary.hpp"

#include <csignal>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/detail/unfinished.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;

class TemporaryTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  /// Runs a child of this program that ends by itself or by a signal; what it came to.
  template <class Work>
  static int in_a_child(Work work) {
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve temporary " + std::to_string(::getpid()));
};

TEST_F(TemporaryTest, IsGoneUnlessKept) {
  {
    Temporary file(folder_ / "a", Temporary::Kind::file);
    const Temporary folder(folder_ / "b", Temporary::Kind::folder);
    write_file(folder.path() / "inner", "x");
    EXPECT_EQ(entries(), 2U);
    write_all(file.descriptor(), "bytes", "a");
    file.keep();
    EXPECT_EQ(read_file(folder_ / "a"), "bytes");
  }
  EXPECT_EQ(entries(), 1U);
}

TEST_F(TemporaryTest, AFileKeepsThePermissionsOfTheOneItReplaces) {
  write_file(folder_ / "a", "old");
  fs::permissions(folder_ / "a", fs::perms(0640));
  write_file(folder_ / "a", "new");
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::perms(0640));
}

TEST_F(TemporaryTest, TheTargetsNameMayBeAsLongAsAny) {
  const fs::path longest = folder_ / std::string(255, 'n');
  write_file(longest, "x");
  EXPECT_EQ(read_file(longest), "x");
}

TEST_F(TemporaryTest, WhatAKilledProgramLeftIsRemovedByTheNextAndNothingElse) {
  const int status = in_a_child([&] {
    const Temporary file(folder_ / "a", Temporary::Kind::file);
    const Temporary folder(folder_ / "b", Temporary::Kind::folder);
    write_file(folder.path() / "inner", "x");
    ::raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(entries(), 2U);
  // Other names, a link and what is in use (by another open file: the lock is that of the file).
  write_file(folder_ / ".wavecurve-1", "a user's");
  write_file(folder_ / ".wavecurve-1-x", "a user's");
  fs::create_symlink(folder_ / ".wavecurve-1", folder_ / ".wavecurve-1-7");
  // A process number that is alive protects nothing: it may have been given anew.
  write_file(folder_ / (".wavecurve-" + std::to_string(::getppid()) + "-3"), "stale");
  const Temporary used(folder_ / "c", Temporary::Kind::file);
  EXPECT_EQ(in_a_child([&] { write_file(folder_ / "." / "d", "y"); }), 0);
  EXPECT_EQ(read_file(folder_ / ".wavecurve-1"), "a user's");
  EXPECT_EQ(read_file(folder_ / ".wavecurve-1-x"), "a user's");
  EXPECT_TRUE(fs::is_symlink(folder_ / ".wavecurve-1-7"));
  EXPECT_TRUE(fs::exists(used.path()));
  EXPECT_EQ(entries(), 5U);
}

TEST_F(TemporaryTest, AProgramThatIsToldToEndLeavesNothing) {
  const int status = in_a_child([&] {
    const Temporary file(folder_ / "a", Temporary::Kind::file);
    const Temporary folder(folder_ / "b", Temporary::Kind::folder);
    write_file(folder.path() / "inner", "x");
    Unfinished().abandon();
    ::raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(entries(), 0U);
}

TEST_F(TemporaryTest, ExchangedFoldersGoBackIfTheOldOneIsNotToBeRemoved) {
  fs::create_directory(folder_ / "a");
  write_file(folder_ / "a" / "old", "x");
  {
    Temporary folder(folder_ / "a", Temporary::Kind::folder);
    write_file(folder.path() / "new", "x");
    EXPECT_THROW(
        folder.exchange([] { throw std::system_error(ENOTEMPTY, std::generic_category()); }),
        std::system_error);
    EXPECT_TRUE(fs::exists(folder_ / "a" / "old"));
    if (!folder.exchange([] {})) GTEST_SKIP() << "this file system exchanges nothing";
  }
  EXPECT_TRUE(fs::exists(folder_ / "a" / "new"));
  EXPECT_FALSE(fs::exists(folder_ / "a" / "old"));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(TemporaryTest, AFolderIsLockedForOneRun) {
  {
    const FolderLock lock(folder_);
    try {
      const FolderLock second(folder_);
      ADD_FAILURE();
    } catch (const std::system_error& error) {
      EXPECT_NE(std::string(error.what()).find("another run is writing to"), std::string::npos);
    }
  }
  EXPECT_NO_THROW(FolderLock{folder_});
  EXPECT_THROW(FolderLock(folder_ / "nothing"), std::system_error);
  EXPECT_EQ(entries(), 0U);
}

}  // namespace
}  // namespace wavecurve::io
