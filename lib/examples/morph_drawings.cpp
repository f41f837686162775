// A morph of two SVG drawings as a Lottie animation: morph_drawings SOURCE.svg DESTINATION.svg
// OUT.json.
// From blob.svg and star.svg beside this file it prints:
//   figure: 1 contours, 256 control points each
//   eye: 1 contours, 256 control points each
#include <cstdio>
#include <exception>
#include <wavecurve/io.hpp>
#include <wavecurve/wavecurve.hpp>

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s SOURCE.svg DESTINATION.svg OUT.json\n", argv[0]);
    return 2;
  }
  const wavecurve::io::DrawingFile source = wavecurve::io::read_drawing(argv[1]),
                                   destination = wavecurve::io::read_drawing(argv[2]);
  const wavecurve::motion::Morph morph =
      wavecurve::motion::make_morph(source.drawing, destination.drawing,
                                    {.bank = wavecurve::find_filter_bank("bspline4.4"),
                                     .samples = 256,
                                     .detail = wavecurve::motion::Detail::blend,
                                     .duration = 2});
  wavecurve::io::write_animation(argv[3], morph, {.frames = 60});
  for (const wavecurve::motion::MorphLayer& layer : morph.layers) {
    std::printf("%s: %zu contours, %d control points each\n", layer.id.c_str(),
                layer.contours.size(), static_cast<int>(layer.scale));
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
