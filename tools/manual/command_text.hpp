#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace wavecurve::tools {

/// An option or a positional argument, in words.
struct OptionText {
  std::vector<std::string> names;    ///< "-o", "--output"; of a positional argument its name
  std::string value;                 ///< "DIR", "INT"; empty for a flag
  std::string bounds;                ///< "INT in [1 - 1000]"; empty if any value is accepted
  std::vector<std::string> choices;  ///< the values that are accepted, where these are listed
  std::string default_value;
  std::string description;
  bool is_required = false;
  bool is_repeatable = false;
};

/// A command with all that can follow it. The first of the path is the program.
struct CommandText {
  std::vector<std::string> path;
  std::string description, footer;
  std::vector<OptionText> options, positionals;
  std::vector<CommandText> commands;
};

/// All of what a definition of commands says, for manual pages and completions.
CommandText command_text(const CLI::App& app);

}  // namespace wavecurve::tools
