#pragma once

#include <filesystem>

namespace wavecurve::tools {

/// The clone that `bench` measures: that of the build tree which the program stands in; of an
/// installed program, where the user stands.
std::filesystem::path clone();

/// A folder or file that the user names, or if that is empty one of the clone.
std::filesystem::path given_or_of_clone(const std::filesystem::path& given,
                                        const std::filesystem::path& below_clone);

}  // namespace wavecurve::tools
