// Proves the map of docs/conventions.md against GSL and PyWavelets: the tables tap by tap, and the
// transforms that the two packages compute of a signal.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#ifdef WAVECURVE_GSL
#include <gsl/gsl_wavelet.h>
#endif

#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve {
namespace {

using Signal = std::vector<double>;

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// How a package differs from the library, in the words of docs/conventions.md: the table entry p
/// acts on the sample 2n + p - offset and is the tap of index first + p, or a zero of the padding;
/// the high-pass filters carry the factor sign.
struct Convention {
  int table_size, offset, first, sign;

  /// c_n of the package is c_n of the library for the signal x(. + shift).
  int shift() const { return -offset - first; }
  /// d_n of the package is sign * d_{n + delay} of the library for the same signal.
  int delay() const { return table_size / 2 - 1 + first; }
};

/// A package's table as a filter in its own indexing, without the zeros it is padded with.
Filter<> without_padding(const Signal& table, int offset) {
  const auto zero = [](double tap) { return tap == 0; };
  const auto begin = std::find_if_not(table.begin(), table.end(), zero);
  const auto end = std::find_if_not(table.rbegin(), table.rend(), zero).base();
  return {static_cast<int>(begin - table.begin()) - offset, {begin, end}};
}

/// The largest |table - sign * filter|, once the table is seen to stand `shift` samples further on.
double worst_tap(const Filter<>& table, const Filter<>& filter, int shift, int sign) {
  EXPECT_EQ(table.size(), filter.size());
  EXPECT_EQ(table.first_index, filter.first_index + shift);
  double worst = 0;
  for (int n = filter.first_index; n <= filter.last_index(); ++n) {
    worst = std::max(worst, std::abs(table[n + shift] - sign * filter[n]));
  }
  return worst;
}

double sum_of_magnitudes(const Filter<>& filter) {
  double sum = 0;
  for (const double tap : filter.taps) sum += std::abs(tap);
  return sum;
}

/// (2.8) for the signal x(. + shift): y_n = sum_l f_{l-2n} x_{l+shift}, periodic.
Signal analyse(const Filter<>& filter, const Signal& x, int shift) {
  const int period = static_cast<int>(x.size());
  Signal y(x.size() / 2);
  for (int n = 0; n < period / 2; ++n) {
    for (int k = filter.first_index; k <= filter.last_index(); ++k) {
      const int sample = ((2 * n + k + shift) % period + period) % period;
      y[static_cast<std::size_t>(n)] += filter[k] * x[static_cast<std::size_t>(sample)];
    }
  }
  return y;
}

/// What the library's filters say the package computes: the coarsest c, then d from coarse to fine.
struct Prediction {
  Signal coefficients;
  double error_bound;
};

Prediction predict(const FilterBank<>& bank, const Convention& package, const Signal& x, int levels,
                   double worst_tap) {
  // With G the larger sum of |taps|, L the table size and a the coefficients of a level:
  // |a| <= G^j |x|, and a level adds to G times the error so far the error of the taps, L worst_tap
  // |a|, and of two rounded sums of L products, 2 L u G |a| each (L u << 1).
  const double gain =
      std::max(sum_of_magnitudes(bank.analysis_low), sum_of_magnitudes(bank.analysis_high));
  Prediction prediction{{}, 0};
  Signal c = x;
  double magnitude = 1;  // the signals lie in [-1, 1]
  const int shift = package.shift(), delay = package.delay();
  for (int level = 0; level < levels; ++level) {
    Signal d = analyse(bank.analysis_high, c, shift);
    const int size = static_cast<int>(d.size());
    std::rotate(d.begin(), d.begin() + (delay % size + size) % size, d.end());
    for (double& value : d) value *= package.sign;
    prediction.coefficients.insert(prediction.coefficients.begin(), d.begin(), d.end());
    c = analyse(bank.analysis_low, c, shift);
    prediction.error_bound =
        gain * prediction.error_bound +
        package.table_size * (worst_tap + 4 * unit_roundoff * gain) * magnitude;
    magnitude *= gain;
  }
  prediction.coefficients.insert(prediction.coefficients.begin(), c.begin(), c.end());
  return prediction;
}

void expect_predicted(const Signal& computed, const Prediction& prediction) {
  ASSERT_EQ(computed.size(), prediction.coefficients.size());
  for (std::size_t n = 0; n < computed.size(); ++n) {
    EXPECT_NEAR(computed[n], prediction.coefficients[n], prediction.error_bound) << "index " << n;
  }
}

#ifdef WAVECURVE_GSL

struct GslFilter {
  const gsl_wavelet_type* type;
  std::size_t member;
  std::string name;
  int sign;
};

/// The filters of both alignments that GSL has.
std::vector<GslFilter> gsl_filters() {
  std::vector<GslFilter> filters{{gsl_wavelet_haar, 2, "haar", 1},
                                 {gsl_wavelet_haar_centered, 2, "haar", 1}};
  for (std::size_t taps = 4; taps <= 20; taps += 2) {
    for (const auto* type : {gsl_wavelet_daubechies, gsl_wavelet_daubechies_centered}) {
      filters.push_back({type, taps, "db" + std::to_string(taps / 2), 1});
    }
  }
  for (const std::size_t member : {103, 105, 202, 204, 206, 208, 301, 303, 305, 307, 309}) {
    const auto order = member / 100, dual = member % 100;
    const std::string name = "bspline" + std::to_string(order) + "." + std::to_string(dual);
    for (const auto* type : {gsl_wavelet_bspline, gsl_wavelet_bspline_centered}) {
      filters.push_back({type, member, name, order % 2 == 0 ? -1 : 1});
    }
  }
  return filters;
}

bool is_centered(const GslFilter& filter) {
  return std::string(filter.type->name).find("centered") != std::string::npos;
}

TEST(Conventions, MapToGsl) {
  constexpr int samples = 64, levels = 6;  // GSL goes down to one coefficient
  Signal x(samples);
  for (int k = 0; k < samples; ++k) x[static_cast<std::size_t>(k)] = std::sin(1.0 + k * k);
  double worst = 0;
  for (const GslFilter& filter : gsl_filters()) {
    SCOPED_TRACE(std::string("GSL ") + filter.type->name + " " + std::to_string(filter.member));
    const std::unique_ptr<gsl_wavelet, void (*)(gsl_wavelet*)> wavelet(
        gsl_wavelet_alloc(filter.type, filter.member), gsl_wavelet_free);
    const std::unique_ptr<gsl_wavelet_workspace, void (*)(gsl_wavelet_workspace*)> workspace(
        gsl_wavelet_workspace_alloc(samples), gsl_wavelet_workspace_free);
    ASSERT_TRUE(wavelet && workspace);
    const int size = static_cast<int>(wavelet->nc);
    const auto bank = find_filter_bank<double>(filter.name);
    const Convention gsl{size, is_centered(filter) ? size / 2 : 0, bank.analysis_low.first_index,
                         filter.sign};

    const auto table = [&](const double* taps) {
      return without_padding({taps, taps + wavelet->nc}, gsl.offset);
    };
    const int shift = gsl.shift(), high_shift = shift + 2 * gsl.delay();
    // The tables h1, g1 analyse; h2, g2 synthesise, at the same places.
    const double worst_here =
        std::max({worst_tap(table(wavelet->h1), bank.analysis_low, shift, 1),
                  worst_tap(table(wavelet->g1), bank.analysis_high, high_shift, gsl.sign),
                  worst_tap(table(wavelet->h2), bank.synthesis_low, shift, 1),
                  worst_tap(table(wavelet->g2), bank.synthesis_high, high_shift, gsl.sign)});
    worst = std::max(worst, worst_here);

    Signal computed = x;
    gsl_wavelet_transform_forward(wavelet.get(), computed.data(), 1, samples, workspace.get());
    expect_predicted(computed, predict(bank, gsl, x, levels, worst_here));
  }
  EXPECT_EQ(worst, 0) << "GSL's tables are no longer the correctly rounded values";
}

#endif

// PyWavelets

/// What pywavelets_tables.py prints; nothing if Debian's PyWavelets is not installed.
std::string output_of_pywavelets() {
  const std::string command = std::string("'") + WAVECURVE_PYTHON + "' '" + WAVECURVE_SOURCE_DIR +
                              "/lib/wavecurve/filters/pywavelets_tables.py'";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), count);
  }
  return pclose(pipe) == 0 ? output : std::string();
}

bool pywavelets_is_installed() {
  return std::system(
             (std::string("'") + WAVECURVE_PYTHON + "' -c 'import pywt' 2>/dev/null").c_str()) == 0;
}

int zeros_at_the_end(const Signal& table) {
  const auto last = std::find_if(table.rbegin(), table.rend(), [](double tap) { return tap != 0; });
  return static_cast<int>(last - table.rbegin());
}

/// How far PyWavelets' tables may lie from the correctly rounded values. No theory bounds another's
/// misprints: these are the decimals that docs/conventions.md says are right, half a unit of the
/// last.
double known_deviation(const std::string& name) {
  if (name.starts_with("sym")) return 0.5e-10;
  for (const char* orders : {"4.4", "5.5", "6.8"}) {
    if (name.ends_with(std::string("bior") + orders) ||
        name.ends_with(std::string("rbio") + orders))
      return 0.5e-11;
  }
  // One unit in the last place of a tap in [1/2, 1): coiflets rounded from a computation in
  // doubles.
  return name.starts_with("coif") ? unit_roundoff : 0;
}

TEST(Conventions, MapToPyWavelets) {
  if (!pywavelets_is_installed()) {
    GTEST_SKIP() << "PyWavelets is not there (Debian: python3-pywt); its map is not tested";
  }
  const std::string output = output_of_pywavelets();
  ASSERT_FALSE(output.empty());
  const auto peer = nlohmann::json::parse(output);
  const auto x = peer["signal"].get<Signal>();

  for (const auto& [name, tables] : peer["filters"].items()) {
    SCOPED_TRACE("PyWavelets " + name);
    const auto bank = find_filter_bank<double>(name);
    const auto dec_lo = tables["dec_lo"].get<Signal>();
    const int first = bank.analysis_low.first_index - zeros_at_the_end(dec_lo);
    const int size = static_cast<int>(dec_lo.size());
    const Convention pywavelets{size, size / 2 - 1, first, first % 2 == 0 ? 1 : -1};

    const auto table = [&](const char* key) {
      return without_padding(tables[key].get<Signal>(), pywavelets.offset);
    };
    const auto reversed_table = [&](const char* key) {
      auto taps = tables[key].get<Signal>();
      std::reverse(taps.begin(), taps.end());
      return without_padding(taps, pywavelets.offset);
    };
    const int shift = pywavelets.shift(), sign = pywavelets.sign;
    EXPECT_EQ(pywavelets.delay(), -shift);  // so the high pass is shifted the other way
    const double worst =
        std::max({worst_tap(reversed_table("dec_lo"), bank.analysis_low, shift, 1),
                  worst_tap(reversed_table("dec_hi"), bank.analysis_high, -shift, sign),
                  worst_tap(table("rec_lo"), bank.synthesis_low, shift, 1),
                  worst_tap(table("rec_hi"), bank.synthesis_high, -shift, sign)});
    std::printf("PyWavelets %s: worst tap differs by %.2g\n", name.c_str(), worst);
    EXPECT_LE(worst, known_deviation(name));

    const int levels = peer["levels"].get<int>();
    expect_predicted(tables["transform"].get<Signal>(),
                     predict(bank, pywavelets, x, levels, worst));
  }
}

}  // namespace
}  // namespace wavecurve
