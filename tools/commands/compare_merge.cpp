#include "tools/commands/compare_merge.hpp"

#include <algorithm>
#include <list>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/output_folder.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/output/study_files.hpp"
#include "tools/commands/terminal.hpp"
#include "verification/study/join_studies.hpp"
#include "verification/study/study_journal.hpp"
#include "verification/study/study_json.hpp"

namespace wavecurve::tools {

namespace {

using namespace verification;

/// The plan that all folders have.
StudyPlan common_plan(const std::vector<std::string>& folders) {
  std::optional<StudyPlan> common;
  for (const std::string& folder : folders) {
    const std::filesystem::path path = std::filesystem::path(folder) / plan_name;
    const StudyPlan plan = plan_of_json(io::read_file(path));
    if (common && *common != plan) {
      throw std::invalid_argument(fmt::format("{} and {} are of different studies: their {} differ",
                                              folders.front(), folder, plan_name));
    }
    common = plan;
  }
  return *common;
}

/// Gives what the journal in a folder has, and says what it does not believe.
PointSource source_of(StudyJournal& journal) {
  return [&journal](const auto& take) {
    journal.read(take);
    for (const std::string& warning : journal.warnings()) print_message(warning);
  };
}

/// Adds to the journal what it does not have.
void complete(StudyJournal& journal, const std::vector<StudyPoint>& points) {
  const PlacesOfPoints places(points);
  std::vector<bool> is_there(points.size());
  journal.read([&](const StudyPoint& point) {
    const auto place = places.find(point);
    if (place) is_there[*place] = points[*place].fingerprint == point.fingerprint;
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_there[i]) journal.append(points[i]);
  }
}

}  // namespace

ExitCode merge_studies(const std::vector<std::string>& folders,
                       const std::filesystem::path& directory, const std::string& format) {
  const StudyPlan plan = common_plan(folders);
  io::OutputFolder output(directory);
  std::list<StudyJournal> journals;
  std::vector<NamedSource> sources;
  const auto add = [&](const std::filesystem::path& folder) -> StudyJournal& {
    StudyJournal& journal = journals.emplace_back(folder / journal_name);
    sources.push_back({folder.string(), source_of(journal)});
    return journal;
  };
  StudyJournal& joined_journal = add(directory);
  for (const std::string& folder : folders) {
    const bool is_there = std::ranges::any_of(sources, [&](const NamedSource& source) {
      return std::filesystem::equivalent(folder, source.name);
    });
    if (!is_there) add(folder);
  }
  const JoinedStudy joined = join_studies(plan, sources);
  complete(joined_journal, joined.points);
  const StudySummary summary = summarize(joined.points);
  write_study_files(plan, joined.points, summary, output.staging());
  output.publish();
  print_study(joined.points, summary, format, directory);
  if (joined.missing == 0) return done;
  print_message(
      fmt::format("{} of {} points are missing; the command of the study with -o {} computes them",
                  joined.missing, joined.missing + joined.points.size(), directory.string()));
  return differs;
}

}  // namespace wavecurve::tools
