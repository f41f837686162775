#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace wavecurve::tracking {

/// Why kernels stay far above their physical limits, as it was found by measuring one revision.
struct LimitReasons {
  std::string commit;  ///< the revision that was measured
  std::map<std::string, std::string> of_kernel;

  /// The reason for a kernel beside a record of revision `shown`, marked if another revision was
  /// measured; "" where none is known.
  std::string text(const std::string& kernel, const std::string& shown) const;
};

/// The latest file of the folder reasons/ in a history, {"commit": ..., "kernels": {KERNEL: REASON}},
/// named as the record that it belongs to; no reasons if there is none. Throws std::invalid_argument
/// naming a file that has another form.
LimitReasons read_limit_reasons(const std::filesystem::path& history);

}  // namespace wavecurve::tracking
