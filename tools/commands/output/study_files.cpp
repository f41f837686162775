#include "tools/commands/output/study_files.hpp"

#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "reports/write_study.hpp"
#include "tools/commands/output/study_text.hpp"
#include "tools/commands/terminal.hpp"
#include "verification/study/study_json.hpp"

namespace wavecurve::tools {

namespace {

using namespace verification;

/// The tables, then what those of several settings come to.
std::string study_as_text(const std::vector<StudyPoint>& points, const StudySummary& summary,
                          const std::filesystem::path& directory) {
  std::string text = study_text(points, summary);
  const auto sentences = reports::answer(points, summary);
  if (settings_of(points).size() > 1) text += fmt::format("\n{}\n", fmt::join(sentences, "\n"));
  return text + (directory.empty() ? "\n-o DIR also writes a page of charts\n"
                                   : fmt::format("\nreport: {}\n",
                                                 printable((directory / "index.html").string())));
}

}  // namespace

void write_study_files(const StudyPlan& plan, const std::vector<StudyPoint>& points,
                       const StudySummary& summary, const std::filesystem::path& folder) {
  io::write_file(folder / plan_name, to_json(plan));
  io::write_file(folder / "compare.json",
                 [&](const io::TextSink& sink) { write_json(points, summary, sink); });
  io::write_file(folder / "compare.csv",
                 [&](const io::TextSink& sink) { write_csv(points, sink); });
  reports::write_study(points, summary, folder);
}

void print_study(const std::vector<StudyPoint>& points, const StudySummary& summary,
                 const std::string& format, const std::filesystem::path& directory) {
  const auto to_stdout = [](std::string_view piece) {
    std::fwrite(piece.data(), 1, piece.size(), stdout);
  };
  if (format == "json") {
    write_json(points, summary, to_stdout);
  } else if (format == "csv") {
    write_csv(points, to_stdout);
  } else {
    print_text(study_as_text(points, summary, directory));
  }
}

}  // namespace wavecurve::tools
