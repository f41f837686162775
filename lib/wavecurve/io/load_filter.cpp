#include "wavecurve/io/load_filter.hpp"

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/nearest_filter_bank.hpp"
#include "wavecurve/certified/user_filter.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/filter_json.hpp"

namespace wavecurve::io {

namespace {

bool is_file(const std::string& name_or_path) { return name_or_path.ends_with(".json"); }

}  // namespace

certified::FilterDefinition load_filter(const std::string& name_or_path) {
  if (is_file(name_or_path)) {
    return certified::define_user_filter(read_filter_json(name_or_path));
  }
  return certified::find_filter(name_or_path);
}

FilterBank<double> load_filter_bank(const std::string& name_or_path) {
  const certified::FilterDefinition definition = load_filter(name_or_path);
  if (is_file(name_or_path)) return certified::nearest_filter_bank(definition);
  return find_filter_bank(definition.name);
}

}  // namespace wavecurve::io
