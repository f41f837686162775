#include "wavecurve/io/load_filter.hpp"

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/user_filter.hpp"
#include "wavecurve/io/filter_json.hpp"

namespace wavecurve::io {

certified::FilterDefinition load_filter(const std::string& name_or_path) {
  if (name_or_path.ends_with(".json")) {
    return certified::define_user_filter(read_filter_json(name_or_path));
  }
  return certified::find_filter(name_or_path);
}

}  // namespace wavecurve::io
