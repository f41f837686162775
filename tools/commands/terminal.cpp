#include "tools/commands/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "wavecurve/filters/detail/characters.hpp"

namespace wavecurve::tools {

namespace {

/// Whether another process of the same mpirun (Open MPI's, MPICH's, or Slurm's) says what there is to
/// say.
bool is_silent_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"}) {
    if (const char* rank = std::getenv(name)) return std::string_view(rank) != "0";
  }
  return false;
}

}  // namespace

void print_text(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += printable(text.substr(0, end));
    if (end < text.size()) lines += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::fwrite(lines.data(), 1, lines.size(), stdout);
}

void print_message(std::string_view message) {
  if (is_silent_rank()) return;
  constexpr std::size_t longest = 2000, beginning = 1000, end = 500;
  std::string line(message);
  if (line.size() > longest) {
    line = line.substr(0, beginning) + " ... " + line.substr(line.size() - end);
  }
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  line = "wavecurve: " + printable(line) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace wavecurve::tools
