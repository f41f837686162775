#include "tools/commands/started_ranks.hpp"

#include <cerrno>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <initializer_list>
#include <sched.h>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

namespace wavecurve::tools {

namespace {

namespace fs = std::filesystem;

/// The first of these variables that is there, as a number.
int number_of(std::initializer_list<const char*> variables, int otherwise) {
  for (const char* name : variables) {
    if (const char* value = std::getenv(name)) return std::atoi(value);
  }
  return otherwise;
}

/// As Open MPI, and MPICH with its relatives, tell their processes; Slurm by PMIx tells only the rank.
int started_count() {
  if (const int count = number_of({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, 0); count > 0) return count;
  return std::getenv("PMIX_RANK") ? number_of({"SLURM_STEP_NUM_TASKS"}, 1) : 1;
}

/// Beside the program in the build tree, in the library folder where it is installed.
fs::path module_path() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {program, program.parent_path() / WAVECURVE_MODULE_FOLDER}) {
    const fs::path path = folder / "wavecurve_mpi.so";
    std::error_code ignored;
    if (fs::exists(path, ignored)) return path;
  }
  return {};
}

[[noreturn]] void fail_without_module(const std::string& why) {
  throw std::runtime_error(
      fmt::format("started by mpirun as one of {} processes, but {}", started_count(), why));
}

}  // namespace

bool is_started_with_others() { return started_count() > 1; }

std::unique_ptr<verification::Ranks> started_ranks() {
  if (!is_started_with_others()) return nullptr;
  const fs::path path = module_path();
  if (path.empty()) fail_without_module("this wavecurve was built without MPI");
  // Parts of MPI, which it loads itself, look for its names among the global ones.
  void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!module) fail_without_module(::dlerror());
  using Open = verification::Ranks* (*)();
  const auto open = reinterpret_cast<Open>(::dlsym(module, "wavecurve_open_ranks"));
  if (!open) fail_without_module(::dlerror());
  return std::unique_ptr<verification::Ranks>(open());
}

void keep_to_a_core(const verification::Ranks& ranks) {
  const long cores = ::sysconf(_SC_NPROCESSORS_ONLN);
  if (ranks.local_count() > cores) {
    throw std::invalid_argument(fmt::format(
        "--one-a-core: {} processes on a machine of {} cores; start at most as many as cores",
        ranks.local_count(), cores));
  }
  cpu_set_t core;
  CPU_ZERO(&core);
  CPU_SET(static_cast<std::size_t>(ranks.local_rank()), &core);
  if (::sched_setaffinity(0, sizeof core, &core) != 0) {
    throw std::system_error(
        errno, std::generic_category(),
        fmt::format("--one-a-core: cannot keep to core {}", ranks.local_rank()));
  }
}

}  // namespace wavecurve::tools
