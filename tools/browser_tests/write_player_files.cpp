// Writes what the browser tests play, and the frames to compare with: write_player_files FOLDER.
#include <cstdio>
#include <exception>
#include <filesystem>

#include <fmt/format.h>

#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/animations/detail/png.hpp"
#include "wavecurve/io/animations/detail/raster.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace {

using namespace wavecurve;

/// Five frames NAME-0.png ... at 0, 1/4 ... of the duration, in the size of the players.
void write_references(const std::filesystem::path& folder, const std::string& name,
                      const motion::Animation& animation) {
  for (int quarter = 0; quarter <= 4; ++quarter) {
    const auto frame = motion::frame_at(animation, animation.duration * quarter / 4);
    io::write_file(folder / fmt::format("{}-{}.png", name, quarter),
                   io::png(io::render(frame, animation.view_box, {500, 400})));
  }
}

void write_all(const std::filesystem::path& folder) {
  io::OutputOptions options;
  options.frames = 61;
  options.pixels = 500;
  options.loop = true;
  const motion::Animation animation = io::sample_animation();
  for (const auto& [name, tolerance] : {std::pair{"polygons", 0.0}, {"cubics", 0.02}}) {
    options.tolerance = tolerance;
    for (const char* ending : {"svg", "json", "html"}) {
      io::write_animation(folder / fmt::format("{}.{}", name, ending), animation, options);
    }
  }
  write_references(folder, "animation", animation);
  motion::Morph morph = io::sample_morph(motion::Detail::blend);
  io::write_animation(folder / "morph.html", morph, options);
  write_references(folder, "blend", motion::animate(morph));
  for (motion::MorphLayer& layer : morph.layers) layer.scale = 64;
  morph.detail = motion::Detail::drop;
  write_references(folder, "drop-64", motion::animate(morph));
  morph.detail = motion::Detail::stage;
  write_references(folder, "stage-64", motion::animate(morph));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("usage: write_player_files FOLDER");
    write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
