#include "tools/manual/completions.hpp"

#include <functional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace wavecurve::tools {

namespace {

/// The commands typed, "/gait/fit"; of the program itself "".
std::string place_of(const CommandText& command) {
  std::string place;
  for (std::size_t i = 1; i < command.path.size(); ++i) place += "/" + command.path[i];
  return place;
}

void visit(const CommandText& command, const std::function<void(const CommandText&)>& see) {
  see(command);
  for (const CommandText& one : command.commands) visit(one, see);
}

/// All places but the program's own, as alternatives of a shell's pattern.
std::string places(const CommandText& program, const char* separator) {
  std::vector<std::string> all;
  visit(program, [&](const CommandText& command) {
    if (command.path.size() > 1) all.push_back(place_of(command));
  });
  return fmt::format("{}", fmt::join(all, separator));
}

/// The first sentence, on one line, in single quotes that end with `quote_within` for one inside.
std::string quoted(const std::string& text, const char* quote_within) {
  std::string result = "'";
  for (const char c : text.substr(0, text.find(". "))) {
    if (c == '\'') {
      result += quote_within;
    } else if (c == '\\') {
      result += "\\\\";
    } else {
      result += c == '\n' ? ' ' : c;
    }
  }
  return result + "'";
}

std::vector<std::string> names_of(const std::vector<OptionText>& options) {
  std::vector<std::string> names;
  for (const OptionText& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> names_of(const std::vector<CommandText>& commands) {
  std::vector<std::string> names;
  for (const CommandText& command : commands) names.push_back(command.path.back());
  return names;
}

/// Cases of a shell's `case "$place $previous"`: an option that takes a value, and what follows it.
std::string value_cases(const CommandText& program, const char* with_choices,
                        const char* with_a_file) {
  std::string cases;
  visit(program, [&](const CommandText& command) {
    for (const OptionText& option : command.options) {
      if (option.value.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) {
        patterns.push_back(fmt::format("'{} {}'", place_of(command), name));
      }
      cases += fmt::format("    {})", fmt::join(patterns, " | "));
      cases += option.choices.empty()
                   ? std::string(with_a_file)
                   : fmt::format(fmt::runtime(with_choices), fmt::join(option.choices, " "));
      cases += "; return ;;\n";
    }
  });
  return cases;
}

}  // namespace

std::string bash_completion(const CommandText& program) {
  std::string text =
      fmt::format(R"(# bash completion of {0}, made from its definition of commands
_{0}() {{
  local place='' word
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $place/$word in
      {1}) place+=/$word ;;
    esac
  done
  COMPREPLY=()
  case "$place $previous" in
{2}  esac
  local commands='' options=''
  case $place in
)",
                  program.path[0], places(program, " | "),
                  value_cases(program, R"( COMPREPLY=($(compgen -W '{}' -- "$current")))", " :"));
  visit(program, [&](const CommandText& command) {
    text += fmt::format("    '{}') commands='{}' options='{}' ;;\n", place_of(command),
                        fmt::join(names_of(command.commands), " "),
                        fmt::join(names_of(command.options), " "));
  });
  return text + fmt::format(R"(  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  elif [[ $commands ]]; then
    COMPREPLY=($(compgen -W "$commands" -- "$current"))
  fi
}}
complete -o default -F _{0} {0}
)",
                            program.path[0]);
}

std::string zsh_completion(const CommandText& program) {
  const char* const quote = "'\\''";
  std::string text = fmt::format(R"(#compdef {0}
# zsh completion of {0}, made from its definition of commands
local place='' word previous=${{words[CURRENT-1]}}
local -a commands options
for word in ${{words[2,CURRENT-1]}}; do
  case $place/$word in
    ({1}) place+=/$word ;;
  esac
done
case "$place $previous" in
{2}esac
case $place in
)",
                                 program.path[0], places(program, "|"),
                                 value_cases(program, " compadd -- {}", " _files"));
  // A colon parts the name from its description.
  visit(program, [&](const CommandText& command) {
    text += fmt::format("  ('{}')\n    commands=(", place_of(command));
    for (const CommandText& one : command.commands) {
      text += fmt::format("\n      {}", quoted(one.path.back() + ":" + one.description, quote));
    }
    text += ")\n    options=(";
    for (const OptionText& option : command.options) {
      for (const std::string& name : option.names) {
        text += fmt::format("\n      {}", quoted(name + ":" + option.description, quote));
      }
    }
    text += ") ;;\n";
  });
  return text + R"(esac
if [[ $PREFIX == -* ]]; then
  _describe -o option options
elif (( $#commands )); then
  _describe command commands
else
  _files
fi
)";
}

std::string fish_completion(const CommandText& program) {
  const char* const quote = "\\'";
  std::string text = fmt::format(R"(# fish completion of {0}, made from its definition of commands
function __{0}_at
  set -l place ''
  for word in (commandline -opc)[2..-1]
    switch $place/$word
      case {1}
        set place $place/$word
    end
  end
  test "$place" = "$argv[1]"
end
)",
                                 program.path[0], places(program, " "));
  visit(program, [&](const CommandText& command) {
    const std::string at =
        fmt::format("complete -c {0} -n \"__{0}_at '{1}'\"", program.path[0], place_of(command));
    for (const CommandText& one : command.commands) {
      text +=
          fmt::format("{} -f -a {} -d {}\n", at, one.path.back(), quoted(one.description, quote));
    }
    for (const OptionText& option : command.options) {
      text += at;
      for (const std::string& name : option.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      if (!option.choices.empty()) {
        text += fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
      } else if (!option.value.empty()) {
        text += " -r -F";
      }
      text += " -d " + quoted(option.description, quote) + "\n";
    }
  });
  return text;
}

}  // namespace wavecurve::tools
