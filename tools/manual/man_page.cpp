#include "tools/manual/man_page.hpp"

#include <cstddef>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/commands/commands.hpp"

namespace wavecurve::tools {

namespace {

/// As troff prints it literally: hyphens of options shall be found and copied as such, and no line
/// shall begin like a request.
std::string literal(const std::string& text) {
  std::string result;
  bool at_start = true;
  for (const char c : text) {
    if (at_start && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    at_start = c == '\n';
  }
  return result;
}

/// Paragraphs of a text that has lines of its own.
std::string lines(const std::string& text) {
  std::string result;
  for (const char c : literal(text))
    result += c == '\n' ? std::string("\n.br\n") : std::string(1, c);
  return result + "\n";
}

std::string joined(const CommandText& command, const char* separator) {
  return fmt::format("{}", fmt::join(command.path, separator));
}

std::string sentence(std::string text) {
  if (!text.empty() && text.back() != '.' && text.back() != '\n') text += '.';
  return text;
}

/// What is accepted and what is taken by default, in brackets.
std::string remarks(const OptionText& option) {
  std::vector<std::string> parts;
  if (option.is_required) parts.push_back("required");
  if (!option.choices.empty()) {
    parts.push_back(fmt::format("one of {}", fmt::join(option.choices, ", ")));
  } else if (!option.bounds.empty()) {
    parts.push_back(option.bounds);
  }
  if (option.is_repeatable) parts.push_back("may be several");
  if (!option.default_value.empty()) parts.push_back("default: " + option.default_value);
  return parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, "; "));
}

std::string entry(const OptionText& option) {
  const bool is_flag = option.value.empty();
  const std::string names = fmt::format("\\fB{}\\fR", fmt::join(option.names, "\\fR, \\fB"));
  std::string text = ".TP\n";
  for (const char c : names + (is_flag ? "" : " \\fI" + option.value + "\\fR")) {
    text += c == '-' ? std::string("\\-") : std::string(1, c);
  }
  return text + "\n" + lines(option.description + remarks(option));
}

std::string entries(const std::vector<OptionText>& options) {
  std::string text;
  for (const OptionText& option : options) text += entry(option);
  return text;
}

std::string synopsis(const CommandText& command) {
  std::string text = fmt::format(".B {}\n", literal(joined(command, " ")));
  if (!command.options.empty()) text += "[\\fIOPTIONS\\fR]\n";
  for (const OptionText& positional : command.positionals) {
    const std::string name =
        "\\fI" + positional.names[0] + "\\fR" + (positional.is_repeatable ? "..." : "");
    text += positional.is_required ? name + "\n" : "[" + name + "]\n";
  }
  if (!command.commands.empty()) text += "\\fICOMMAND\\fR\n";
  return text;
}

/// The commands below one that has a page: all that they accept.
std::string commands_below(const CommandText& command) {
  std::string text;
  for (const CommandText& one : command.commands) {
    text += fmt::format(".SS {}\n{}.PP\n{}{}{}{}", literal(joined(one, " ")), synopsis(one),
                        lines(sentence(one.description)), entries(one.positionals),
                        entries(one.options), commands_below(one));
  }
  return text;
}

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (std::size_t code = 0; code < std::size(exit_code_meanings); ++code) {
    text += fmt::format(".TP\n.B {}\n{}", code, lines(sentence(exit_code_meanings[code])));
  }
  return text;
}

std::string opening(const CommandText& command, const std::string& version) {
  return fmt::format(
      ".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}",
      literal(joined(command, "-")), command.path[0], version, literal(joined(command, "-")),
      literal(command.description.substr(0, command.description.find(". "))), synopsis(command));
}

ManPage program_page(const CommandText& program, const std::string& version) {
  std::string text = opening(program, version) + ".SH DESCRIPTION\n" +
                     lines(sentence(program.description)) + ".SH OPTIONS\n" +
                     entries(program.options) + ".SH COMMANDS\n";
  std::vector<std::string> pages;
  for (const CommandText& command : program.commands) {
    text += fmt::format(".TP\n.B {}\n{}", literal(command.path.back()),
                        lines(sentence(command.description)));
    pages.push_back(fmt::format("\\fB{}\\fR(1)", literal(joined(command, "-"))));
  }
  text += exit_status();
  text += fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
  return {joined(program, "-") + ".1", text};
}

ManPage command_page(const CommandText& command, const std::string& version) {
  std::string text =
      opening(command, version) + ".SH DESCRIPTION\n" + lines(sentence(command.description));
  if (!command.footer.empty()) text += ".PP\n" + lines(command.footer);
  if (!command.positionals.empty()) text += ".SH ARGUMENTS\n" + entries(command.positionals);
  text += ".SH OPTIONS\n" + entries(command.options);
  if (!command.commands.empty()) text += ".SH COMMANDS\n" + commands_below(command);
  text += exit_status();
  text += fmt::format(".SH SEE ALSO\n\\fB{}\\fR(1)\n", command.path[0]);
  return {joined(command, "-") + ".1", text};
}

}  // namespace

std::vector<ManPage> man_pages(const CommandText& program, const std::string& version) {
  std::vector<ManPage> pages{program_page(program, version)};
  for (const CommandText& command : program.commands) {
    pages.push_back(command_page(command, version));
  }
  return pages;
}

}  // namespace wavecurve::tools
