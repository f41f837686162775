#include "benchmarks/tracking/build.hpp"

#include <algorithm>
#include <stdexcept>

#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"

namespace wavecurve::tracking {

namespace fs = std::filesystem;

std::vector<fs::path> Build::all_programs() const {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(programs)) {
    const std::string file = entry.path().filename().string();
    if (file.ends_with("_benchmark") && file != "kernel_benchmark") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  if (has_kernels()) found.insert(found.begin(), kernel_program());
  return found;
}

Json ask(const Build& build, const std::string& question) {
  const std::string answer = io::output_of({build.kernel_program().string(), question});
  try {
    return io::parse_ordered_json(answer);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("kernel_benchmark " + question + " answers what is " +
                                error.what());
  }
}

Build build_in(const fs::path& folder) {
  for (const fs::path& place : {folder, folder / "bin"}) {
    std::error_code ignored;
    if (!fs::is_directory(place, ignored)) continue;
    const fs::path absolute = fs::canonical(place);
    Build build{folder.string(), absolute, {{"commit", "build"}}};
    if (!build.all_programs().empty()) return build;
  }
  throw std::invalid_argument("'" + folder.string() + "': no *_benchmark program there");
}

}  // namespace wavecurve::tracking
