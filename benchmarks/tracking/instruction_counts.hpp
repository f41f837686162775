#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wavecurve::tracking {

/// What one run of a kernel takes, as simulated: independent of the machine's load and speed, but
/// not of compiler, libraries and the vectors that valgrind's processor has.
struct Counts {
  double instructions = 0, data_reads = 0, data_writes = 0;
  double data_references() const { return data_reads + data_writes; }
};

/// A kernel of kernel_benchmark, its size, and how many runs are counted together.
struct CountedKernel {
  std::string name;
  long size;
  long runs = 1;
};

/// Counted by valgrind: callgrind with cachegrind's simulator, which can be told to count only
/// within the function measured_work of the program. So neither the start of the program nor that
/// of its libraries is in it (Highway's measures the clock, and takes another number of
/// instructions each time), and all kernels are counted by one process. The median of three of
/// them, since where the heap has its blocks makes up to 0.2 %; per run, in the order given.
/// Throws std::system_error if valgrind is not there, std::runtime_error if it fails.
std::vector<Counts> count_instructions(const std::filesystem::path& program,
                                       const std::vector<CountedKernel>& kernels,
                                       int processes = 3);

/// "valgrind-3.19.0". Throws as above.
std::string valgrind_version();

}  // namespace wavecurve::tracking
