// The table of exit codes holds for every command of both programs.
#include "tools/run_main.hpp"

#include <iterator>
#include <string>
#include <vector>

#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

class ExitCodes : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    io::write_file(folder_ / "a.svg", "<svg><path id='a' d='M0 0H9V9H0Z'/></svg>");
    io::write_file(folder_ / "file", "");
  }
};

TEST_F(ExitCodes, AreRightForBadInput) {
  for (const char* command :
       {"filter no.json", "coefficients no.json", "check no.csv", "stiffness no.json",
        "morph no.svg a.svg -o b.svg", "describe no.svg", "reconstruct no.json -o b.svg",
        "compare --filter no.json", "compare --samples 3", "gait fit no.csv -o b.json",
        "gait synthesize no.json a.svg -o b.svg", "gait show no.json",
        "bench compare no.json no.json", "bench check no", "bench self-test no", "bench peers no",
        "bench record no", "bench history --history no", "verify --only no"}) {
    expect_refusal(command, "wavecurve: ");
  }
}

TEST_F(ExitCodes, AreRightForALoopOfLinksAndANameThatIsTooLong) {
  for (const char* name : {"loop.json", "loop.csv", "loop.svg", "loop.csv.gz"}) {
    std::filesystem::create_symlink(name, folder_ / name);
  }
  for (const char* command :
       {"filter loop.json", "coefficients loop.json", "check loop.csv", "stiffness loop.json",
        "morph loop.svg a.svg -o b.svg", "morph loop.csv a.svg -o b.svg", "describe loop.svg",
        "reconstruct loop.json -o b.svg", "compare --filter loop.json", "compare --shape loop.svg",
        "gait fit loop.csv -o b.json", "gait fit loop.csv.gz -o b.json", "gait show loop.json",
        "gait synthesize loop.json a.svg -o b.svg", "bench compare loop.json loop.json",
        "bench check loop"}) {
    expect_refusal(command, "wavecurve: ");
  }
  const std::string name(300, 'n');
  for (const std::string& command :
       {"filter " + name + ".json", "check " + name + ".csv", "describe " + name + ".svg",
        "gait fit " + name + ".csv -o b.json", "bench check " + name}) {
    expect_refusal(command, "wavecurve: ");
  }
}

TEST_F(ExitCodes, AreRightForABadCommandLine) {
  for (const char* command : {"",
                              "filter",
                              "coefficients",
                              "check",
                              "stiffness",
                              "morph",
                              "describe",
                              "reconstruct",
                              "compare --no",
                              "gait",
                              "gait fit",
                              "gait synthesize",
                              "gait show",
                              "bench",
                              "bench compare",
                              "bench record --no",
                              "bench check --no",
                              "bench self-test --no",
                              "bench history --no",
                              "bench peers --blocks 1",
                              "verify --no",
                              "no"}) {
    expect_refusal(command, "wavecurve: ");
  }
}

TEST_F(ExitCodes, AreRightForOutputThatCannotBeWritten) {
  for (const char* command :
       {"stiffness db4 --samples 16 --output file/K.mtx", "morph a.svg a.svg -o file/b.svg",
        "describe a.svg -o file/b.json", "compare --samples 16 -o file/b",
        "verify --only erratum-2-5 --output file/report"}) {
    const ProgramRun failed = wavecurve(command);
    EXPECT_EQ(failed.exit_code, 3) << command;
    EXPECT_NE(failed.err.find("file/"), std::string::npos) << command << ": " << failed.err;
    EXPECT_EQ(failed.err.find('\n'), failed.err.size() - 1) << command << ": " << failed.err;
  }
}

TEST_F(ExitCodes, AreRightForAFullStandardOutput) {
  for (const char* command : {"--help", "--version", "filter db2", "filter --list", "check --help",
                              "verify --list", "bench compare --help"}) {
    const ProgramRun full = run("cd '" + folder_.string() + "' && { '" WAVECURVE_PROGRAM "' " +
                                command + " >/dev/full; }");
    EXPECT_EQ(full.exit_code, 3) << command;
    EXPECT_EQ(full.err, "wavecurve: cannot write to the standard output\n") << command;
  }
}

TEST_F(ExitCodes, AreTheSameOfTheProgramForBenchAlone) {
  io::write_file(folder_ / "no_record.json", "{}");
  for (const char* command :
       {"", "bench", "bench compare", "bench compare no.json no.json", "bench check no",
        "bench compare no_record.json no_record.json", "bench self-test no", "bench record no",
        "bench record . --history file/b --repetitions 0", "bench compare --help >/dev/full"}) {
    const auto run_of = [&](const char* program) {
      return run("cd '" + folder_.string() + "' && { '" + program + "' " + command + "; }");
    };
    const ProgramRun one = run_of(WAVECURVE_PROGRAM), alone = run_of(WAVECURVE_BENCH_PROGRAM);
    EXPECT_GE(one.exit_code, 2) << command;
    EXPECT_EQ(alone.exit_code, one.exit_code) << command;
    EXPECT_EQ(alone.err, one.err) << command;
  }
}

TEST_F(ExitCodes, StandInTheDocumentation) {
  const std::string page = io::read_file(WAVECURVE_SOURCE_DIR "/docs/index.md");
  for (std::size_t code = 0; code < std::size(exit_code_meanings); ++code) {
    const std::string row = "| " + std::to_string(code) + " | " + exit_code_meanings[code] + " |\n";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace wavecurve::tools
