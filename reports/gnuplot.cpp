#include "gnuplot.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "wavecurve/io/read_file.hpp"
#include "wavecurve/io/write_file.hpp"

extern char** environ;

namespace wavecurve::reports {

namespace {

namespace fs = std::filesystem;
using verification::Chart;

/// What all charts share: a readable size, generic fonts, line styles that differ in dashes and
/// point shape as well as in colour, and a light grid.
constexpr std::string_view style = R"(set encoding utf8
set datafile separator tab
set datafile commentschars ""
set key autotitle columnheader
set key noenhanced outside top left horizontal reverse Left
set border 3 linecolor rgb "#555555"
set tics nomirror out scale 0.6
set grid linecolor rgb "#dddddd" linewidth 0.7
set linetype 1 linecolor rgb "#1f5a96" linewidth 2 dashtype 1 pointtype 7 pointsize 0.6
set linetype 2 linecolor rgb "#b3541e" linewidth 2 dashtype 2 pointtype 5 pointsize 0.6
set linetype 3 linecolor rgb "#2e7d4f" linewidth 2 dashtype 4 pointtype 9 pointsize 0.7
set linetype 4 linecolor rgb "#7b4a9e" linewidth 2 dashtype 3 pointtype 13 pointsize 0.7
set linetype 5 linecolor rgb "#333333" linewidth 2 dashtype 5 pointtype 4 pointsize 0.7
)";

std::string script_text(const Chart& chart) {
  std::string text = "# Draw anew: gnuplot " + chart.id + ".gp\n";
  text += "set terminal svg size 760,430 font \"sans-serif,14\" background rgb \"#ffffff\"\n";
  text += "set output \"" + chart.id + ".svg\"\n";
  text += style;
  text += "data = \"" + chart.id + ".dat\"\n";
  text += chart.script;
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

std::string data_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::string cell : cells) {
    std::ranges::replace_if(
        cell, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    line += cell + "\t";
  }
  if (!line.empty()) line.back() = '\n';
  return line;
}

std::string data_text(const verification::Table& table) {
  std::string text = data_line(table.columns);
  for (const auto& row : table.rows) text += data_line(row);
  return text;
}

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// The child's working directory, and its standard streams: no input, its output and its complaints
/// into a file.
class ChildSetup {
 public:
  ChildSetup(const fs::path& directory, const fs::path& complaints) {
    posix_spawn_file_actions_init(&actions_);
    // Opened before the change of directory: both paths may be relative to ours.
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 2, complaints.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0666);
    posix_spawn_file_actions_adddup2(&actions_, 2, 1);
    posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
  }
  ~ChildSetup() { posix_spawn_file_actions_destroy(&actions_); }
  ChildSetup(const ChildSetup&) = delete;
  ChildSetup& operator=(const ChildSetup&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// The status of `gnuplot script`, run in the directory.
int run_gnuplot(std::string script, const fs::path& directory, const fs::path& complaints) {
  const ChildSetup setup(directory, complaints);
  std::string program = "gnuplot";
  char* arguments[] = {program.data(), script.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", setup.actions(), nullptr, arguments, environ);
  if (error != 0) fail(error, "cannot run gnuplot (Debian package gnuplot-nox)");
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) fail(errno, "cannot wait for gnuplot");
  }
  return status;
}

/// gnuplot echoes a faulty command before the line that says what is wrong with it,
/// "ID.gp" line 25: undefined variable: x.
std::string first_complaint(std::string_view text, const std::string& script) {
  const std::size_t start = text.find("\"" + script + "\" line ");
  if (start != std::string_view::npos) text.remove_prefix(start);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text.empty() ? "no reason given" : std::string(text.substr(0, text.find('\n')));
}

}  // namespace

void draw_chart(const Chart& chart, const fs::path& directory) {
  const std::string script = chart.id + ".gp";
  const fs::path picture = directory / (chart.id + ".svg");
  const fs::path complaints = directory / (chart.id + ".err");
  io::write_file(directory / script, script_text(chart));
  io::write_file(directory / (chart.id + ".dat"), data_text(chart.data));
  // An older picture must not pass for the one that gnuplot failed to draw.
  fs::remove(picture);
  const int status = run_gnuplot(script, directory, complaints);
  const std::string complaint = io::read_file(complaints);
  fs::remove(complaints);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !fs::exists(picture)) {
    throw std::runtime_error("gnuplot failed on " + (directory / script).string() + ": " +
                             first_complaint(complaint, script));
  }
}

}  // namespace wavecurve::reports
