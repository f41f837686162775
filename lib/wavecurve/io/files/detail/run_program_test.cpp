#include "wavecurve/io/files/detail/run_program.hpp"

#include <stdexcept>
#include <system_error>

#include <gtest/gtest.h>

namespace wavecurve::io {
namespace {

TEST(RunProgram, TakesOutputAndExitCode) {
  const ProgramRun run = run_program({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.out, "out\n");
  EXPECT_EQ(run.err, "err\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).exit_code, -1);
}

TEST(RunProgram, StandsWhereItIsToldAndReadsNothing) {
  EXPECT_EQ(output_of({"pwd"}, "/"), "/\n");
  EXPECT_EQ(output_of({"sh", "-c", "echo $LC_ALL $X; cat"}, {}, {"X=a b"}), "C a b\n");
}

TEST(RunProgram, SaysWhatFailed) {
  EXPECT_THROW(run_program({"no-such-program"}), std::system_error);
  try {
    output_of({"sh", "-c", "echo it broke >&2; exit 1"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("it broke"), std::string::npos);
  }
}

}  // namespace
}  // namespace wavecurve::io
