// Every example of README.md and of the guide is run again and must print what the page shows; the
// README's C++ program is one of lib/examples.
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

/// Runs a page's examples one after the other in a folder where what they read stands.
class Pages : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    for (const char* shown : {"verification", "docs", "benchmarks"}) {
      std::filesystem::create_symlink(source_ / shown, folder_ / shown);
    }
  }

  void expect_truth_of(const std::filesystem::path& page, std::size_t least_examples) {
    const auto examples = examples_of(io::read_file(page));
    EXPECT_GE(examples.size(), least_examples) << page;
    const std::string bin = std::filesystem::path(WAVECURVE_PROGRAM).parent_path().string();
    for (const auto& [command, shown] : examples) {
      const ProgramRun result = run("cd '" + folder_.string() + "' && PATH='" + bin +
                                    "':\"$PATH\" && { " + command + "; }");
      std::string printed = trimmed(result.out + result.err), expected = trimmed(shown);
      if (expected.ends_with("\n...\n")) {
        expected.resize(expected.size() - 4);
        printed.resize(std::min(printed.size(), expected.size()));
      }
      EXPECT_EQ(printed, expected) << page << ": " << command;
    }
  }

  const std::filesystem::path source_ = WAVECURVE_SOURCE_DIR;
};

TEST_F(Pages, TheReadmeShowsWhatTheProgramPrints) { expect_truth_of(source_ / "README.md", 6); }

TEST_F(Pages, TheGuideShowsWhatTheProgramPrints) {
  for (const auto& page : std::filesystem::directory_iterator(source_ / "docs" / "guide")) {
    if (page.path().extension() == ".md") expect_truth_of(page.path(), 1);
  }
}

/// Which is compiled, run, and held against what it says that it prints: lib/examples.
TEST_F(Pages, TheReadmeShowsAnExampleWordForWord) {
  const std::string readme = io::read_file(source_ / "README.md");
  const std::string opening = "```cpp\n";
  const auto begin = readme.find(opening);
  ASSERT_NE(begin, std::string::npos);
  const auto end = readme.find("```\n", begin + opening.size());
  EXPECT_EQ(readme.substr(begin + opening.size(), end - begin - opening.size()),
            io::read_file(source_ / "lib/examples/stiffness.cpp"));
}

}  // namespace
}  // namespace wavecurve::tools
