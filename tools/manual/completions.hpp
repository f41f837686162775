#pragma once

#include <string>

#include "tools/manual/command_text.hpp"

namespace wavecurve::tools {

// What a shell reads to complete a command line: commands, options, and the values of options that
// list them; every other word is completed as a file.

std::string bash_completion(const CommandText& program);
std::string zsh_completion(const CommandText& program);
std::string fish_completion(const CommandText& program);

}  // namespace wavecurve::tools
