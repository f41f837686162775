// How many digits of their filter tables are right: GSL's, PyWavelets' and our own, each tap
// against an enclosure of 128 bits. Prints JSON: for each family and table the worst tap in units
// in the last place. The argument is what lib/wavecurve/filters/pywavelets_tables.py prints;
// --versions prints those of the peers that are linked.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#ifdef WAVECURVE_GSL
#include <gsl/gsl_version.h>
#include <gsl/gsl_wavelet.h>
#endif
#ifdef WAVECURVE_SUNDIALS
#include <sundials/sundials_config.h>
#endif

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/read_file.hpp"

namespace {

using namespace wavecurve;
using Json = nlohmann::ordered_json;
using Taps = std::vector<double>;

constexpr long bits = 128;

/// The distance from a number to the next one away from zero.
double unit_in_the_last_place(double x) {
  const double magnitude = std::abs(x);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

/// In units of the last place of the true tap; padding with zeros aside.
double worst_tap(Taps table, const Filter<certified::Ball>& exact) {
  const auto is_zero = [](double tap) { return tap == 0; };
  table.erase(table.begin(), std::find_if_not(table.begin(), table.end(), is_zero));
  table.erase(std::find_if_not(table.rbegin(), table.rend(), is_zero).base(), table.end());
  if (table.size() != exact.taps.size()) return std::numeric_limits<double>::quiet_NaN();
  const certified::WorkingPrecision precision(bits);
  double worst = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto error = certified::abs(certified::Ball::from_double(table[i]) - exact.taps[i]);
    worst = std::max(worst, error.to_double() / unit_in_the_last_place(exact.taps[i].to_double()));
  }
  return worst;
}

double worst_of_bank(const Taps& analysis, const Taps& synthesis, const std::string& name) {
  const auto bank = certified::find_filter(name).bank(bits);
  return std::max(worst_tap(analysis, bank.analysis_low), worst_tap(synthesis, bank.synthesis_low));
}

/// Keeps the worst filter of each family.
void add(Json& json, const std::string& table, const std::string& name, double worst) {
  const std::string family = name.substr(0, name.find_first_of("0123456789"));
  Json& entry = json[family.empty() ? name : family][table];
  if (entry.is_null()) entry = {{"filters", 0}, {"worst_ulps", -1.0}, {"worst_filter", name}};
  entry["filters"] = entry["filters"].get<int>() + 1;
  if (!(worst <= entry["worst_ulps"].get<double>())) {
    entry["worst_ulps"] = worst;
    entry["worst_filter"] = name;
  }
}

#ifdef WAVECURVE_GSL
void add_gsl(Json& json) {
  const auto add_member = [&](const gsl_wavelet_type* type, std::size_t member,
                              const std::string& name) {
    gsl_wavelet* wavelet = gsl_wavelet_alloc(type, member);
    const Taps h1(wavelet->h1, wavelet->h1 + wavelet->nc);
    const Taps h2(wavelet->h2, wavelet->h2 + wavelet->nc);
    add(json, "GSL", name, worst_of_bank(h1, h2, name));
    gsl_wavelet_free(wavelet);
  };
  for (std::size_t taps = 4; taps <= 20; taps += 2) {
    add_member(gsl_wavelet_daubechies, taps, "db" + std::to_string(taps / 2));
  }
  for (const std::size_t member : {103, 105, 202, 204, 206, 208, 301, 303, 305, 307, 309}) {
    add_member(gsl_wavelet_bspline, member,
               "bspline" + std::to_string(member / 100) + "." + std::to_string(member % 100));
  }
}

#else
void add_gsl(Json&) {}
#endif

void print_versions() {
#ifdef WAVECURVE_GSL
  std::printf("GSL %s", GSL_VERSION);
#else
  std::printf("no GSL");
#endif
#ifdef WAVECURVE_SUNDIALS
  std::printf(", SUNDIALS %s\n", SUNDIALS_VERSION);
#else
  std::printf(", no SUNDIALS\n");
#endif
}

void add_pywavelets(Json& json, const Json& tables) {
  for (const auto& [name, filter] : tables.at("filters").items()) {
    Taps analysis = filter.at("dec_lo").get<Taps>();
    std::ranges::reverse(analysis);
    const std::string own = certified::canonical_filter_name(name);
    add(json, "PyWavelets", own, worst_of_bank(analysis, filter.at("rec_lo").get<Taps>(), own));
  }
}

void add_own(Json& json) {
  for (const std::string& name : certified::filter_names()) {
    const auto bank = find_filter_bank<double>(name);
    add(json, "wavecurve", name,
        worst_of_bank(bank.analysis_low.taps, bank.synthesis_low.taps, name));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string_view(argv[1]) == "--versions") {
      print_versions();
      return 0;
    }
    Json json;
    add_own(json);
    add_gsl(json);
    if (argc > 1) add_pywavelets(json, io::parse_ordered_json(io::read_file(argv[1])));
    std::puts(json.dump(1).c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "filter_digits: %s\n", error.what());
    return 1;
  }
}
