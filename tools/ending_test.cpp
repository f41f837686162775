// How the program ends when it is told to, and what it does with broken standard streams.
#include "tools/ending.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <thread>

#include "wavecurve/io/files/detail/folder_lock.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class Ending : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    fs::create_directory(work_);
    fs::create_directory(folder_ / "bin");
    io::write_file(folder_ / "a.svg", "<svg><path id='a' d='M0 0H9V9H0Z'/></svg>");
    io::write_file(folder_ / "b.svg", "<svg><path id='a' d='M0 0H5V9H0Z'/></svg>");
  }

  /// Starts the program; it stands in a folder of its own.
  pid_t start(const std::string& arguments) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    fs::current_path(work_);
    const std::string path = (folder_ / "bin").string() + ":" + std::getenv("PATH");
    ::setenv("PATH", path.c_str(), 1);
    ::execl("/bin/sh", "sh", "-c",
            ("exec '" WAVECURVE_PROGRAM "' " + arguments + " >/dev/null").c_str(), nullptr);
    ::_exit(127);
  }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(work_), {}));
  }

  template <class Condition>
  static bool soon(Condition condition) {
    for (int i = 0; i < 2000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(5ms);
    }
    return false;
  }

  const fs::path work_ = folder_ / "work";
};

int status_of(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// While ffmpeg works; the stand-in tells its process number, and would stay for ever.
TEST_F(Ending, BySignalRemovesTemporariesAndEndsChildren) {
  const fs::path there = folder_ / "there";
  io::write_file(folder_ / "bin" / "ffmpeg",
                 "#!/bin/sh\necho $$ >'" + there.string() + "'\nexec sleep 1000\n");
  fs::permissions(folder_ / "bin" / "ffmpeg", fs::perms::owner_all);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t program = start("morph ../a.svg ../b.svg -o o.mp4");
    ASSERT_TRUE(soon([&] { return fs::exists(there) && fs::file_size(there) > 0; }));
    EXPECT_EQ(entries(), 1u) << "the video that is made";
    const pid_t child = std::stoi(io::read_file(there));
    EXPECT_EQ(::kill(child, 0), 0);
    ::kill(program, signal);
    const int status = status_of(program);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(entries(), 0u);
    // Where nobody waits for orphans, it stays a zombie, which has no command line.
    EXPECT_TRUE(soon([&] {
      const std::string line = "/proc/" + std::to_string(child) + "/cmdline";
      return !fs::exists(line) || io::read_file(line).empty();
    }));
    fs::remove(there);
  }
}

// In a certified computation that takes minutes.
TEST_F(Ending, AnInterruptedComputationSaysSoInOneLine) {
  const fs::path err = folder_ / "err";
  const pid_t program = start(
      "coefficients db20 --integral \"phi' phi(l) phi(m)\" --digits 1000 2>'" + err.string() + "'");
  std::this_thread::sleep_for(500ms);
  ::kill(program, SIGINT);
  const int status = status_of(program);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  EXPECT_EQ(io::read_file(err), "wavecurve: interrupted\n");
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Ending, AtAnyMomentLeavesNothing) {
  for (const char* output : {"o.png", "o.svg", "o.gif"}) {
    for (const auto wait : {5ms, 20ms, 40ms, 80ms, 160ms}) {
      const pid_t program = start("morph ../a.svg ../b.svg --frames 300 -o " + std::string(output));
      std::this_thread::sleep_for(wait);
      ::kill(program, SIGTERM);
      status_of(program);
      for (const auto& entry : fs::directory_iterator(work_)) {
        EXPECT_TRUE(entry.path().filename().string().starts_with("o.")) << entry.path();
      }
    }
  }
}

TEST_F(Ending, WhatAKilledRunLeftIsRemovedByTheNext) {
  const pid_t program = start("morph ../a.svg ../b.svg --frames 1000 -o o.png");
  ASSERT_TRUE(soon([&] { return entries() == 1; }));
  ::kill(program, SIGKILL);
  status_of(program);
  ASSERT_EQ(entries(), 1u);
  EXPECT_EQ(status_of(start("morph ../a.svg ../b.svg -o o.svg")), 0);
  EXPECT_TRUE(fs::exists(work_ / "o.svg"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Ending, AnIgnoredSignalStaysIgnored) {
  const ProgramRun run = this->run(
      "cd '" + folder_.string() +
      "' && { trap '' HUP; '" WAVECURVE_PROGRAM
      "' morph a.svg b.svg --frames 60 -o o.png & p=$!; sleep 0.05; kill -HUP $p; wait $p; }");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(folder_ / "o.png" / "frame-0060.png"));
}

TEST_F(Ending, WithoutAnErrorStreamTheWorkIsDone) {
  io::write_file(folder_ / "warned.svg", "<svg><text/><path d='M0 0H9V9H0Z'/></svg>");
  for (const char* stream : {"2>&-", "2>/dev/full", "2>&- >&- <&-"}) {
    const ProgramRun run =
        this->run("cd '" + folder_.string() + "' && rm -f o.svg && { '" +
                  WAVECURVE_PROGRAM "' morph warned.svg b.svg -o o.svg " + stream + "; }");
    EXPECT_EQ(run.exit_code, 0) << stream << run.err;
    EXPECT_TRUE(io::read_file(folder_ / "o.svg").starts_with("<svg")) << stream;
  }
}

TEST_F(Ending, AClosedOutputIsAFailureAndABrokenPipeEndsIt) {
  EXPECT_EQ(run("{ '" WAVECURVE_PROGRAM "' filter db2 >&-; }").exit_code, 3);
  const ProgramRun pipe = run("{ { '" WAVECURVE_PROGRAM "' --help; echo $? >&2; } | true; }");
  // 141 is 128 + SIGPIPE; 0 if all was written before `true` had gone.
  EXPECT_TRUE(pipe.err == "141\n" || pipe.err == "0\n") << pipe.err;
}

TEST_F(Ending, TheSecondOfTwoRunsOnOneFolderIsTold) {
  fs::create_directory(folder_ / "r.png");
  {
    const io::FolderLock first(folder_ / "r.png");
    for (const char* command :
         {"compare --samples 16 -o r.png", "verify --only erratum-2-5 --output r.png",
          "morph a.svg b.svg -o r.png"}) {
      const ProgramRun second = wavecurve(command);
      EXPECT_EQ(second.exit_code, 3) << command;
      EXPECT_EQ(second.err,
                "wavecurve: another run is writing to r.png: Device or resource busy\n");
      EXPECT_TRUE(fs::is_empty(folder_ / "r.png")) << command;
    }
  }
  EXPECT_EQ(wavecurve("morph a.svg b.svg --frames 2 -o r.png").exit_code, 0);
}

}  // namespace
}  // namespace wavecurve::tools
