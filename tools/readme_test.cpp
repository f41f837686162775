// Every example of README.md is run again and must print what the README shows; its C++ program is
// one of lib/examples.
#include <sstream>
#include <string>
#include <vector>

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

struct Example {
  std::string command;
  std::string output;  ///< a last line "..." stands for the rest
};

/// The lines of the ```console blocks: "$ COMMAND", then what it prints.
std::vector<Example> examples_of(const std::string& markdown) {
  std::vector<Example> examples;
  std::istringstream lines(markdown);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = line == "```console";
    } else if (inside && line.starts_with("$ ")) {
      examples.push_back({line.substr(2), ""});
    } else if (inside && !examples.empty()) {
      examples.back().output += line + "\n";
    }
  }
  return examples;
}

/// Without blanks before line ends, which editors take away, and without blank lines at the end.
std::string trimmed(const std::string& text) {
  std::string result, line;
  std::istringstream lines(text);
  while (std::getline(lines, line)) {
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + "\n";
  }
  while (result.ends_with("\n\n")) result.pop_back();
  return result;
}

using Readme = ProgramTest;

TEST_F(Readme, ShowsWhatTheProgramPrints) {
  const std::filesystem::path source = WAVECURVE_SOURCE_DIR;
  for (const char* shown : {"verification", "docs"}) {
    std::filesystem::create_symlink(source / shown, folder_ / shown);
  }
  const auto examples = examples_of(io::read_file(source / "README.md"));
  ASSERT_GE(examples.size(), 14U);
  const std::string bin = std::filesystem::path(WAVECURVE_PROGRAM).parent_path().string();
  for (const auto& [command, shown] : examples) {
    const ProgramRun result = run("cd '" + folder_.string() + "' && PATH='" + bin +
                                  "':\"$PATH\" && { " + command + "; }");
    std::string printed = trimmed(result.out + result.err), expected = trimmed(shown);
    if (expected.ends_with("\n...\n")) {
      expected.resize(expected.size() - 4);
      printed.resize(std::min(printed.size(), expected.size()));
    }
    EXPECT_EQ(printed, expected) << command;
  }
}

/// Which is compiled, run, and held against what it says that it prints: lib/examples.
TEST_F(Readme, ShowsAnExampleWordForWord) {
  const std::filesystem::path source = WAVECURVE_SOURCE_DIR;
  const std::string readme = io::read_file(source / "README.md");
  const std::string opening = "```cpp\n";
  const auto begin = readme.find(opening);
  ASSERT_NE(begin, std::string::npos);
  const auto end = readme.find("```\n", begin + opening.size());
  EXPECT_EQ(readme.substr(begin + opening.size(), end - begin - opening.size()),
            io::read_file(source / "lib/examples/stiffness.cpp"));
}

}  // namespace
}  // namespace wavecurve::tools
