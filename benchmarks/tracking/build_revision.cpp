#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <stdexcept>
#include <sys/file.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/run_program.hpp"

#include "benchmarks/tracking/build.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;

std::string without_newline(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string git(const fs::path& root, std::vector<std::string> arguments,
                const std::vector<std::string>& environment = {}) {
  arguments.insert(arguments.begin(), "git");
  return without_newline(io::output_of(arguments, root, environment));
}

/// One at a time: the worktree serves all.
class Lock {
 public:
  explicit Lock(const fs::path& path)
      : descriptor_(::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX) != 0) {
      throw std::system_error(errno, std::generic_category(), "cannot lock " + path.string());
    }
  }
  ~Lock() { ::close(descriptor_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int descriptor_;
};

/// The working tree as a commit, by an index of its own; HEAD where nothing is changed.
std::string snapshot(const fs::path& root, const fs::path& folder) {
  const std::vector<std::string> identity{
      "GIT_INDEX_FILE=" + (folder / "index").string(), "GIT_AUTHOR_NAME=wavecurve",
      "GIT_AUTHOR_EMAIL=wavecurve@localhost", "GIT_COMMITTER_NAME=wavecurve",
      "GIT_COMMITTER_EMAIL=wavecurve@localhost"};
  git(root, {"read-tree", "HEAD"}, identity);
  git(root, {"add", "--all"}, identity);
  const std::string tree = git(root, {"write-tree"}, identity);
  if (tree == git(root, {"rev-parse", "HEAD^{tree}"})) return git(root, {"rev-parse", "HEAD"});
  return git(root, {"commit-tree", tree, "-p", "HEAD", "-m", "The working tree"}, identity);
}

std::string commit_of(const fs::path& root, const std::string& revision) {
  const io::ProgramRun found = io::run_program(
      {"git", "rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"},
      root);
  if (found.exit_code == 0) return without_newline(found.out);
  throw std::invalid_argument("'" + revision + "' is no revision of " + root.string() +
                              ", no record and no folder with programs");
}

Json describe(const fs::path& root, const std::string& commit, bool is_dirty) {
  return {{"commit", commit},
          {"date", git(root, {"show", "-s", "--format=%cI", commit})},
          {"subject", git(root, {"show", "-s", "--format=%s", commit})},
          {"is_dirty", is_dirty}};
}

/// Programs depend on no more than the sources and the compiler; headers of libraries are seen by
/// ninja, or told by kernel_benchmark --environment.
std::string key_of(const fs::path& root, const std::string& commit) {
  const std::string compiler = io::output_of({"c++", "--version"});
  const char* flags = std::getenv("CXXFLAGS");
  const std::size_t hash = std::hash<std::string>()(compiler + (flags ? flags : ""));
  return git(root, {"rev-parse", "--short=16", commit + "^{tree}"}) +
         fmt::format("-{:08x}", hash & 0xffffffff);
}

void check_out(const fs::path& root, const fs::path& worktree, const std::string& commit) {
  if (fs::exists(worktree / ".git")) {
    git(worktree, {"checkout", "--quiet", "--force", "--detach", commit});
    git(worktree, {"clean", "-fdq"});
    return;
  }
  git(root, {"worktree", "prune"});
  git(root, {"worktree", "add", "--quiet", "--force", "--detach", worktree.string(), commit});
}

std::vector<std::string> targets(const fs::path& worktree, Programs programs) {
  if (programs == Programs::kernels && fs::exists(worktree / "benchmarks/kernel_benchmark.cpp")) {
    return {"kernel_benchmark"};
  }
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(worktree / "benchmarks")) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ".cpp" && stem.ends_with("_benchmark")) all.push_back(stem);
  }
  return all;
}

std::vector<std::string> compile(const fs::path& worktree, const fs::path& tree,
                                 Programs programs) {
  io::output_of({"cmake", "-S", worktree.string(), "-B", tree.string(), "-G", "Ninja",
                 "-DCMAKE_BUILD_TYPE=Release", "-DWAVECURVE_TESTS=OFF", "-DWAVECURVE_PROGRAMS=OFF",
                 "-DWAVECURVE_BENCHMARKS=ON"});
  const std::vector<std::string> chosen = targets(worktree, programs);
  const std::string processors = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::string> command{"cmake",      "--build",  tree.string(),
                                   "--parallel", processors, "--target"};
  command.insert(command.end(), chosen.begin(), chosen.end());
  io::output_of(command);
  return chosen;
}

/// Whole or not at all: into a folder beside, which is then renamed.
void keep(const fs::path& tree, const std::vector<std::string>& chosen, const fs::path& kept) {
  const fs::path temporary = kept.string() + ".tmp";
  fs::remove_all(temporary);
  fs::create_directories(temporary);
  for (const std::string& program : chosen) {
    fs::copy(tree / "bin" / program, temporary / program);
  }
  fs::remove_all(kept);
  fs::rename(temporary, kept);
}

}  // namespace

Build build_revision(const fs::path& root, const std::string& revision, Programs programs) {
  if (!fs::exists(root / ".git")) {
    throw std::invalid_argument("'" + (revision.empty() ? "." : revision) +
                                "' is no record and no folder with programs, and " + root.string() +
                                " is no clone whose revisions could be built");
  }
  const fs::path folder = fs::absolute(root) / "build" / "bench";
  fs::create_directories(folder);
  const Lock lock(folder / "lock");
  const bool is_working_tree = revision.empty();
  const std::string commit = is_working_tree ? snapshot(root, folder) : commit_of(root, revision);
  const bool is_dirty = is_working_tree && commit != git(root, {"rev-parse", "HEAD"});

  const fs::path kept =
      folder / (key_of(root, commit) + (programs == Programs::all ? "-all" : "-kernels"));
  if (!fs::is_directory(kept)) {
    const fs::path worktree = folder / "worktree", tree = folder / "tree";
    check_out(root, worktree, commit);
    keep(tree, compile(worktree, tree, programs), kept);
  }
  return {is_working_tree ? "working tree" : revision, kept, describe(root, commit, is_dirty)};
}

}  // namespace wavecurve::tracking
