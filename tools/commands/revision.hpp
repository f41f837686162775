#pragma once

namespace wavecurve::tools {

/// The revision of the sources: `git describe --always --dirty`, or "unknown". Written at each build by
/// tools/package/revision.cmake into a file of its own, so that a commit compiles nothing else.
extern const char* const revision;

}  // namespace wavecurve::tools
