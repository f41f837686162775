// Frames of a morph, correspondence and crossings, each with its plain peer beside it; and whole
// morphs of real drawings, with their crossings and sizes.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <string>

#include <benchmark/benchmark.h>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/animations/lottie.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/motion/morph/avoid_crossings.hpp"
#include "wavecurve/motion/morph/contour_morph.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"

namespace wavecurve {
namespace {

using Eigen::Index;

/// A wavy ring, its waves and start depending on `leaves`.
Contour rosette(Index points, int leaves) {
  Contour contour(points, 2);
  for (Index i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double radius = 3 + std::cos(leaves * t) + 0.3 * std::sin(t + leaves);
    contour.row(i) << radius * std::cos(t), radius * std::sin(t);
  }
  return contour;
}

void linear_frame(benchmark::State& state, const char* filter) {
  const motion::ContourPair pair{rosette(1024, 5), rosette(1024, 12)};
  motion::ContourMorph morph(find_filter_bank(filter), 1024, 8, 1024);
  Contour points(1024, 2);
  for (auto _ : state) {
    morph.frame(pair, 0.3, motion::detail_shares(motion::Detail::blend, 0.25, 0.3), points);
    benchmark::DoNotOptimize(points.data());
  }
}
BENCHMARK_CAPTURE(linear_frame, D8, "db4")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(linear_frame, cubic_spline, "bspline4.4")->Unit(benchmark::kMicrosecond);

void correspondence(benchmark::State& state) {
  const Contour from = rosette(state.range(0), 5), to = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(best_shift(from, to, Rotation::taken_out));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(correspondence)
    ->RangeMultiplier(4)
    ->Range(256, 65536)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity(benchmark::oNLogN);

void exhaustive_correspondence(benchmark::State& state) {
  const Contour from = rosette(state.range(0), 5), to = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(plain::best_shift(from, to, Rotation::taken_out));
}
BENCHMARK(exhaustive_correspondence)->Arg(4096)->Unit(benchmark::kMicrosecond);

void crossings(benchmark::State& state) {
  const Contour contour = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(count_crossings(contour));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(crossings)
    ->RangeMultiplier(4)
    ->Range(256, 65536)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity(benchmark::oNLogN);

void plain_crossings(benchmark::State& state) {
  const Contour contour = rosette(state.range(0), 12);
  for (auto _ : state) benchmark::DoNotOptimize(plain::count_crossings(contour));
}
BENCHMARK(plain_crossings)->Arg(1024)->Unit(benchmark::kMicrosecond);

/// From two files to the text of a Lottie file, as `wavecurve morph --detail stage --scale K`.
/// Counters: layers; bytes; proper crossings in nine intermediate frames, all layers together.
void morph_to_lottie(benchmark::State& state, const std::string& source,
                     const std::string& destination, Index scale) {
  motion::MorphOptions options{
      .bank = find_filter_bank("bspline4.4"), .samples = 1024, .scale = scale};
  options.detail = motion::Detail::stage;
  std::string lottie;
  motion::Morph morph;
  for (auto _ : state) {
    morph = motion::make_morph(io::read_drawing(source).drawing,
                               io::read_drawing(destination).drawing, options);
    lottie = io::lottie(motion::animate(morph), {});
  }
  Index total = 0;
  for (const motion::MorphLayer& layer : morph.layers) {
    const auto counts = motion::crossings(morph, layer, {.1, .2, .3, .4, .5, .6, .7, .8, .9});
    total = std::accumulate(counts.begin(), counts.end(), total);
  }
  state.counters["layers"] = static_cast<double>(morph.layers.size());
  state.counters["bytes"] = static_cast<double>(lottie.size());
  state.counters["crossings"] = static_cast<double>(total);
}

void register_pair(const std::string& name, const std::filesystem::path& source,
                   const std::filesystem::path& destination) {
  if (!exists(source) || !exists(destination)) return;
  for (const Index scale : {1024, 64, 16}) {
    benchmark::RegisterBenchmark(("morph_to_lottie/" + name + "/" + std::to_string(scale)).c_str(),
                                 morph_to_lottie, source.string(), destination.string(), scale)
        ->Unit(benchmark::kMillisecond);
  }
}

/// The shipped faces, and the shared drawings where they are beside the source.
const bool registered = [] {
  const std::filesystem::path root = WAVECURVE_SOURCE_DIR, examples = root / "docs/examples",
                              shared = root / "../shared/data";
  register_pair("face-dog-cat", examples / "face-dog.svg", examples / "face-cat.svg");
  for (const char* face : {"bear_koala", "dog_cat_side", "fx_dog_cat_side", "neutral_frown",
                           "openmouth_grin", "smile_frown"}) {
    const std::string stem = face;
    register_pair(stem, shared / "faces" / (stem + "_A.svg"), shared / "faces" / (stem + "_B.svg"));
  }
  for (const auto& [a, b] : {std::pair{"dog", "horse"}, {"camel", "elephant"}, {"fish", "bird"}}) {
    register_pair(std::string(a) + "-" + b, shared / "silhouettes" / (std::string(a) + "-1.svg"),
                  shared / "silhouettes" / (std::string(b) + "-1.svg"));
  }
  return true;
}();

}  // namespace
}  // namespace wavecurve
