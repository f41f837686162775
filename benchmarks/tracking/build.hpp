#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/tracking/record.hpp"

namespace wavecurve::tracking {

/// Benchmark programs that can be run.
struct Build {
  std::string name;                ///< as it was asked for
  std::filesystem::path programs;  ///< the folder with *_benchmark
  Json revision;                   ///< commit, date, subject, is_dirty; of a folder nothing

  std::filesystem::path kernel_program() const { return programs / "kernel_benchmark"; }
  bool has_kernels() const { return exists(kernel_program()); }
  /// All *_benchmark, kernel_benchmark first, then by name.
  std::vector<std::filesystem::path> all_programs() const;
};

/// What kernel_benchmark answers to --kernels, --environment, --accuracy, --limits.
/// Throws std::runtime_error where it fails, std::invalid_argument where it answers no JSON.
Json ask(const Build& build, const std::string& question);

/// A folder with programs, or a build tree with bin/ in it. Throws std::invalid_argument if there
/// are none.
Build build_in(const std::filesystem::path& folder);

enum class Programs { kernels, all };

/// Builds a revision of the repository at `root`; "" is the working tree with all its changes, of
/// which a commit that no branch knows is made. One git worktree below build/bench, one build tree
/// and hence the same paths serve all revisions: what two have in common is compiled once, and
/// equal code makes equal programs. Programs are kept by the contents of the tree and the
/// compiler, and found there again.
/// Throws std::invalid_argument for an unknown revision, std::runtime_error if it does not build.
Build build_revision(const std::filesystem::path& root, const std::string& revision,
                     Programs programs);

}  // namespace wavecurve::tracking
