#include "tools/commands/clone.hpp"

#include "verification/suite/data_folder.hpp"

namespace wavecurve::tools {

namespace fs = std::filesystem;

fs::path clone() {
  const fs::path tree = verification::source_tree();
  return tree.empty() ? fs::current_path() : tree;
}

fs::path given_or_of_clone(const fs::path& given, const fs::path& below_clone) {
  return given.empty() ? clone() / below_clone : given;
}

}  // namespace wavecurve::tools
