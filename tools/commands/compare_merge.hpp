#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/commands/commands.hpp"

namespace wavecurve::tools {

/// Joins the points that several runs of one study have in these folders, and those that are in the
/// directory already, into the directory, with all files that a whole run writes, and prints them as
/// print_study does. `differs` if points are missing, which a message then says.
/// Throws std::invalid_argument for folders that hold no study or different ones, or that disagree
/// about a point (join_studies.hpp); std::system_error if a run is writing to one of them.
ExitCode merge_studies(const std::vector<std::string>& folders,
                       const std::filesystem::path& directory, const std::string& format);

}  // namespace wavecurve::tools
