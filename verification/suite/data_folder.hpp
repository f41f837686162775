#pragma once

#include <filesystem>
#include <vector>

namespace wavecurve::verification {

/// The folder of the data that the programs read: published/ (tables as they are printed),
/// examples/ (drawings and a walk) and reference/ (the blessed verdicts). It is share/wavecurve
/// beside the folder of the running program, so that an installed tree may stand anywhere; in a
/// build tree links of these names lead to the sources. Throws std::system_error, naming the
/// file, if one of data_files() is not there: no result may change because one is missing.
std::filesystem::path data_folder();

/// From now on data_folder() is this folder: for a library in another's program, as in Python's
/// interpreter. Throws as data_folder() does.
void use_data_folder(const std::filesystem::path& folder);

/// The files of published/ and examples/ that the program was built with, as paths in data_folder().
const std::vector<std::filesystem::path>& data_files();

/// The source tree whose build tree the running program stands in; empty for an installed program.
std::filesystem::path source_tree();

/// The same of a program with this path.
std::filesystem::path data_folder_of(const std::filesystem::path& program);
std::filesystem::path source_tree_of(const std::filesystem::path& program);

}  // namespace wavecurve::verification
