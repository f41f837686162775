#include "wavecurve/io/files/detail/child_process.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/detail/unfinished.hpp"

namespace wavecurve::io {
namespace {

using namespace std::chrono_literals;

TEST(ChildProcess, IsWrittenToAndReadFromAtTheSameTime) {
  // Far more than a pipe holds, both ways: who only wrote first would wait for ever.
  const std::string text(std::size_t{3} << 20, 'x');
  ChildProcess cat({"cat"}, {.has_input = true});
  EXPECT_TRUE(cat.write(text));
  EXPECT_EQ(cat.finish(), 0);
  EXPECT_EQ(cat.out(), text);
}

TEST(ChildProcess, ThatReadsNoMoreIsNoticed) {
  ChildProcess child({"sh", "-c", "exec 0<&-; echo enough >&2"}, {.has_input = true});
  const std::string text(std::size_t{8} << 20, 'x');
  EXPECT_FALSE(child.write(text));
  EXPECT_EQ(child.finish(), 0);
  EXPECT_EQ(child.err(), "enough\n");
}

TEST(ChildProcess, ThatPrintsWithoutEndIsRefused) {
  ChildProcess yes({"yes"});
  EXPECT_THROW(yes.finish(), std::runtime_error);
}

TEST(ChildProcess, IsKilledWithAllThatItStarted) {
  const auto start = std::chrono::steady_clock::now();
  { ChildProcess child({"sh", "-c", "sleep 100 & sleep 100"}); }
  EXPECT_LT(std::chrono::steady_clock::now() - start, 50s);
}

TEST(ChildProcess, EndsWithTheProgramThatIsToldToEnd) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t program = ::fork();
  if (program == 0) {
    ::close(ends[0]);
    // The sleeping grandchild holds the pipe open for as long as it lives.
    ChildProcess child(
        {"sh", "-c", "exec 9>&" + std::to_string(ends[1]) + "; sleep 100; sleep 100"});
    ::usleep(200000);
    Unfinished().abandon();
    ::_exit(0);
  }
  ::close(ends[1]);
  char byte;
  EXPECT_EQ(::read(ends[0], &byte, 1), 0) << "the end, and not after 100 seconds";
  ::close(ends[0]);
  ::waitpid(program, nullptr, 0);
}

TEST(ChildProcess, HasSignalsAsAProgramExpectsThem) {
  ::signal(SIGPIPE, SIG_IGN);
  ChildProcess child({"sh", "-c", "kill -PIPE $$; echo alive"});
  EXPECT_EQ(child.finish(), -1);
  EXPECT_EQ(child.out(), "");
  ::signal(SIGPIPE, SIG_DFL);
}

}  // namespace
}  // namespace wavecurve::io
