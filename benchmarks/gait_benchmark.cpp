// A recorded trot (111 frames, 4 limbs of 128 points) fitted, and a drawing of 5 layers that walks
// by it. The record is in the folder of shared data beside the project.
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/io/tracks/read_limb_tracks.hpp"
#include "wavecurve/motion/gait/model/fit_gait.hpp"
#include "wavecurve/motion/gait/walk/gait_animation.hpp"

namespace wavecurve {
namespace {

const std::filesystem::path source = WAVECURVE_SOURCE_DIR;
const std::filesystem::path name = "../shared/data/gait/dog_trot_limb_contours.csv.gz";
const std::filesystem::path record = source / name;

bool is_missing(benchmark::State& state) {
  if (std::filesystem::exists(record)) return false;
  state.SkipWithError(("there is no " + name.string()).c_str());
  return true;
}

gait::GaitFitOptions full_scale() { return {find_filter_bank("bspline4.4"), "bspline4.4"}; }

void fit_all_models(benchmark::State& state) {
  if (is_missing(state)) return;
  const gait::LimbTracks tracks = io::read_limb_tracks({record});
  gait::GaitFitOptions options = full_scale();
  if (state.range(0) > 0) options.scale = state.range(0);
  for (auto _ : state) benchmark::DoNotOptimize(gait::fit_gait(tracks, options));
}
// Control points; 0: all 128 points.
BENCHMARK(fit_all_models)->Arg(32)->Arg(64)->Arg(0)->Unit(benchmark::kMillisecond);

void fit_the_publications_quadratic(benchmark::State& state) {
  if (is_missing(state)) return;
  const gait::LimbTracks tracks = io::read_limb_tracks({record});
  gait::GaitFitOptions options = full_scale();
  options.models = {gait::GaitModel::quadratic};
  for (auto _ : state) benchmark::DoNotOptimize(gait::fit_gait(tracks, options));
}
BENCHMARK(fit_the_publications_quadratic)->Unit(benchmark::kMillisecond);

void synthesize(benchmark::State& state) {
  if (is_missing(state)) return;
  gait::GaitFitOptions fit_options = full_scale();
  fit_options.scale = 64;
  const gait::GaitParameters parameters =
      gait::fit_gait(io::read_limb_tracks({record}), fit_options).parameters;
  Drawing drawing = io::read_drawing(source / "docs/examples/dog.svg").drawing;
  std::erase_if(drawing.layers,
                [](const Layer& layer) { return layer.id.size() != 2 && layer.id != "BODY"; });
  gait::GaitAnimationOptions options{fit_options.bank};
  options.frames = 240;
  options.samples = 256;
  for (auto _ : state) benchmark::DoNotOptimize(gait::animate_gait(parameters, drawing, options));
  state.counters["frames"] = benchmark::Counter(240, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(synthesize)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wavecurve
