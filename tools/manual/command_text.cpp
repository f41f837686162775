#include "tools/manual/command_text.hpp"

#include <sstream>

namespace wavecurve::tools {

namespace {

/// "{a,b,c}" as a list; empty for any other text.
std::vector<std::string> choices_in(const std::string& text) {
  std::vector<std::string> choices;
  if (!text.starts_with('{') || !text.ends_with('}')) return choices;
  std::istringstream inside(text.substr(1, text.size() - 2));
  for (std::string choice; std::getline(inside, choice, ',');) choices.push_back(choice);
  return choices;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (!option.nonpositional()) return {option.get_name(true)};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

OptionText option_text(const CLI::Option& option) {
  OptionText text;
  text.names = names_of(option);
  text.description = option.get_description();
  text.is_required = option.get_required();
  if (option.get_items_expected_max() == 0) return text;
  // The parser writes "TYPE:BOUNDS", or "TYPE" alone.
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  text.value = type.substr(0, colon);
  if (colon != std::string::npos) text.bounds = type.substr(colon + 1);
  text.choices = choices_in(text.bounds);
  text.default_value = option.get_default_str();
  text.is_repeatable = option.get_expected_max() > 1;
  return text;
}

CommandText text_below(const CLI::App& app, std::vector<std::string> path) {
  path.push_back(app.get_name());
  CommandText text{path, app.get_description(), app.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    (option->nonpositional() ? text.options : text.positionals).push_back(option_text(*option));
  }
  for (const CLI::App* command : app.get_subcommands({})) {
    text.commands.push_back(text_below(*command, path));
  }
  return text;
}

}  // namespace

CommandText command_text(const CLI::App& app) { return text_below(app, {}); }

}  // namespace wavecurve::tools
