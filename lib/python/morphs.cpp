// Morphs of drawings, linear and as the motion of elastic curves.
#include <optional>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/motion/morph/make_morph.hpp"
#include "wavecurve/motion/morph/physical_motion.hpp"

#include "python/filter_source.hpp"
#include "python/interruptible.hpp"
#include "python/topics.hpp"

namespace wavecurve::python {

namespace {

using motion::Animation;
using motion::Morph;

motion::Detail detail_of(const std::string& name) {
  if (name == "drop") return motion::Detail::drop;
  if (name == "blend") return motion::Detail::blend;
  if (name == "stage") return motion::Detail::stage;
  throw std::invalid_argument(
      unknown_name("detail", name, std::vector<std::string>{"drop", "blend", "stage"}));
}

Morph made(const io::DrawingFile& source, const io::DrawingFile& destination,
           const PythonFilter& filter, Eigen::Index samples, std::optional<Eigen::Index> scale,
           const std::string& detail, double duration, bool rotation,
           const std::vector<std::pair<std::string, std::string>>& map) {
  motion::MorphOptions options{.bank = filter.bank};
  options.samples = samples;
  options.scale = scale;
  options.detail = detail_of(detail);
  options.duration = duration;
  options.rotation = rotation ? Rotation::taken_out : Rotation::kept;
  options.map = map;
  return interruptible([from = source.drawing, to = destination.drawing, options] {
    return motion::make_morph(from, to, options);
  });
}

Animation animated(const Morph& morph) {
  return interruptible([morph] { return motion::animate(morph); });
}

Animation moved(const Morph& morph, int frames, const std::string& solver,
                std::optional<double> until, double density, double stiffness, double bending,
                double mass_damping, double stiffness_damping) {
  motion::PhysicalOptions options;
  options.material = {.density = density,
                      .stiffness = stiffness,
                      .bending = bending,
                      .mass_damping = mass_damping,
                      .stiffness_damping = stiffness_damping};
  options.until = until;
  options.solver = solver;
  options.frames = frames;
  return interruptible([morph, options] { return motion::physical_animation(morph, options); });
}

py::list frame(const Animation& animation, double time) {
  py::list layers;
  for (const motion::FrameLayer& layer : motion::frame_at(animation, time)) {
    layers.append(py::make_tuple(layer.id, layer.contours));
  }
  return layers;
}

io::OutputOptions output_options(int frames, bool loop, int pixels) {
  io::OutputOptions options;
  options.frames = frames;
  options.loop = loop;
  options.pixels = pixels;
  return options;
}

/// A file; None is what the worker returns.
template <class Moving>
void write(const Moving& moving, const std::filesystem::path& path, int frames,
           std::optional<double> tolerance, bool loop, int pixels) {
  io::OutputOptions options = output_options(frames, loop, pixels);
  options.tolerance = tolerance.value_or(io::usual_tolerance(path, moving.view_box, options));
  interruptible([=] { io::write_animation(path, moving, options); });
}

template <class Moving>
void add_write(py::class_<Moving>& type) {
  type.def("write", &write<Moving>, py::arg("path"), py::arg("frames"), py::arg("tolerance"),
           py::arg("loop"), py::arg("pixels"));
}

}  // namespace

void add_morphs(py::module_& module) {
  py::class_<Animation> animation(module, "NativeAnimation", "Outlines, piecewise linear in time.");
  animation.def_property_readonly("duration", [](const Animation& a) { return a.duration; })
      .def("frame", &frame, py::arg("time"));
  add_write(animation);
  py::class_<Morph> morph(module, "NativeMorph", "One drawing into another.");
  morph
      .def(py::init(&made), py::arg("source"), py::arg("destination"), py::arg("filter"),
           py::arg("samples"), py::arg("scale"), py::arg("detail"), py::arg("duration"),
           py::arg("rotation"), py::arg("map"))
      .def("animate", &animated)
      .def("move", &moved, py::arg("frames"), py::arg("solver"), py::arg("until"),
           py::arg("density"), py::arg("stiffness"), py::arg("bending"), py::arg("mass_damping"),
           py::arg("stiffness_damping"));
  add_write(morph);
}

}  // namespace wavecurve::python
