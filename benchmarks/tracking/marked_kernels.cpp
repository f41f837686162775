#include "benchmarks/tracking/marked_kernels.hpp"

#include <limits>

#include "wavecurve/io/files/detail/json_place.hpp"

namespace wavecurve::tracking {

namespace {

using Place = io::OrderedJsonPlace;

long count_in(const Place& place) { return place.whole_number(1, std::numeric_limits<int>::max()); }

MarkedKernel kernel_in(const Place& place) {
  MarkedKernel kernel;
  kernel.name = place.at("name").text();
  kernel.size = count_in(place.at("size"));
  if (const auto runs = place.find("counted_runs")) kernel.counted_runs = count_in(*runs);
  if (const auto plain = place.find("plain")) kernel.is_plain = plain->value() == true;
  if (const auto growth = place.find("growth")) kernel.growth = growth->text();
  if (const auto sizes = place.find("sizes")) {
    for (const Place& size : sizes->elements()) kernel.sizes.push_back(count_in(size));
  }
  return kernel;
}

}  // namespace

std::vector<MarkedKernel> marked_kernels(const Build& build) {
  const Json answer = ask(build, "--kernels");
  std::vector<MarkedKernel> kernels;
  for (const Place& place : Place(answer).elements()) kernels.push_back(kernel_in(place));
  return kernels;
}

}  // namespace wavecurve::tracking
