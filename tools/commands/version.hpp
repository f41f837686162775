#pragma once

#include <string>

namespace wavecurve::tools {

/// What --version prints, a line each: version, revision of the sources (`git describe`, or unknown
/// where they are no clone), compiler, versions of FLINT, Eigen and Highway, and the instruction set
/// that Highway's kernels use on this machine.
std::string version_text();

}  // namespace wavecurve::tools
