// What help tells of the program, manual pages and completions tell, too.
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

namespace fs = std::filesystem;

const fs::path manual = WAVECURVE_MANUAL;

/// A command by the words that call it, and what its help lists.
struct HelpText {
  std::vector<std::string> path;
  std::vector<std::string> options, commands;
  std::vector<std::string> unchecked;  ///< options that take numbers without stating their range
};

class Manual : public ProgramTest {
 protected:
  /// The command and all below it, read from their help.
  std::vector<HelpText> help_below(const std::vector<std::string>& path = {}) const {
    std::string words;
    for (const std::string& word : path) words += word + " ";
    HelpText help{path, {}, {}, {}};
    std::istringstream lines(wavecurve(words + "--help").out);
    std::string section;
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      if (!line.empty() && line[0] != ' ') section = line;
      if (std::regex_search(line, match, std::regex("^  ((-\\w,)?--[\\w-]+)"))) {
        std::istringstream names(match[1]);
        for (std::string name; std::getline(names, name, ',');) help.options.push_back(name);
        if (std::regex_search(line, std::regex(" (INT|UINT|FLOAT)(?!:(from|above) )"))) {
          help.unchecked.push_back(words + help.options.back());
        }
      } else if (section == "Subcommands:" &&
                 std::regex_search(line, match, std::regex("^  ([\\w-]+)"))) {
        help.commands.push_back(match[1]);
      }
    }
    std::vector<HelpText> all{help};
    for (const std::string& command : help.commands) {
      auto below = path;
      below.push_back(command);
      for (HelpText& one : help_below(below)) all.push_back(std::move(one));
    }
    return all;
  }

  /// The words that bash offers for the last one of a command line.
  std::set<std::string> offered(const std::string& line) const {
    const ProgramRun completed = run(
        "bash -c 'source \"$0\"; read -ra COMP_WORDS <<<\"$1\"; "
        "[[ $1 != *\" \" ]] || COMP_WORDS+=(\"\"); "
        "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _wavecurve; printf \"%s\\n\" \"${COMPREPLY[@]}\"' '" +
        (manual / "wavecurve").string() + "' '" + line + "'");
    EXPECT_EQ(completed.err, "") << line;
    std::set<std::string> words;
    std::istringstream lines(completed.out);
    for (std::string word; std::getline(lines, word);) {
      if (!word.empty()) words.insert(word);
    }
    return words;
  }

  bool is_there(const std::string& program) const {
    return run("command -v " + program).exit_code == 0;
  }
};

std::string call(const std::vector<std::string>& path) {
  std::string words = "wavecurve ";
  for (const std::string& word : path) words += word + " ";
  return words;
}

TEST_F(Manual, EveryOptionThatTakesNumbersChecksThem) {
  for (const HelpText& help : help_below()) EXPECT_EQ(help.unchecked, std::vector<std::string>());
}

TEST_F(Manual, PagesNameEveryCommandAndOption) {
  const auto all = help_below();
  ASSERT_GE(all.size(), 20U);
  for (const HelpText& help : all) {
    const std::string page = "wavecurve" + (help.path.empty() ? "" : "-" + help.path[0]) + ".1";
    std::string text = io::read_file(manual / page);
    std::erase(text, '\\');
    for (const std::string& option : help.options) {
      EXPECT_NE(text.find("fB" + option + "fR"), std::string::npos) << page << ": " << option;
    }
    for (const std::string& command : help.commands) {
      EXPECT_NE(text.find(command), std::string::npos) << page << ": " << command;
    }
  }
}

TEST_F(Manual, PagesAreFreeOfFormattingErrors) {
  if (!is_there("groff")) GTEST_SKIP() << "no groff";
  for (const auto& file : fs::directory_iterator(manual)) {
    if (file.path().extension() != ".1") continue;
    const ProgramRun formatted = run("groff -man -ww -z -Tutf8 '" + file.path().string() + "'");
    EXPECT_EQ(formatted.exit_code, 0);
    EXPECT_EQ(formatted.err, "");
  }
}

TEST_F(Manual, BashCompletesEveryCommandAndOption) {
  if (!is_there("bash")) GTEST_SKIP() << "no bash";
  for (const HelpText& help : help_below()) {
    EXPECT_EQ(offered(call(help.path) + "-"),
              std::set<std::string>(help.options.begin(), help.options.end()));
    EXPECT_EQ(offered(call(help.path)),
              std::set<std::string>(help.commands.begin(), help.commands.end()));
  }
  EXPECT_EQ(offered("wavecurve bench c"), (std::set<std::string>{"check", "compare"}));
  EXPECT_EQ(offered("wavecurve filter D8 --format c"), (std::set<std::string>{"csv", "cpp"}));
  EXPECT_EQ(offered("wavecurve bench compare --json "), std::set<std::string>());
}

TEST_F(Manual, OtherShellsReadTheirs) {
  if (is_there("zsh")) {
    const ProgramRun read = run("zsh -n '" + (manual / "_wavecurve").string() + "'");
    EXPECT_EQ(read.exit_code, 0) << read.err;
  }
  if (is_there("fish")) {
    const ProgramRun read =
        run("HOME='" + folder_.string() +
            "' fish -c 'source $argv[1]; and complete -C \"wavecurve bench c\"' '" +
            (manual / "wavecurve.fish").string() + "'");
    EXPECT_EQ(read.exit_code, 0) << read.err;
    EXPECT_EQ(read.err, "");
    EXPECT_NE(read.out.find("check\t"), std::string::npos) << read.out;
    EXPECT_NE(read.out.find("compare\t"), std::string::npos) << read.out;
    EXPECT_EQ(read.out.find("filter"), std::string::npos) << read.out;
  }
}

}  // namespace
}  // namespace wavecurve::tools
