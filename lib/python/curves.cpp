// Curves: drawings, samples, descriptors, distances of shapes, points of wavelet curves.
#include <optional>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/crossings.hpp"
#include "wavecurve/curves/descriptor.hpp"
#include "wavecurve/curves/normalized_contour.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/shape_distance.hpp"
#include "wavecurve/curves/wavelet_curve.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/descriptor_json.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"

#include "python/filter_source.hpp"
#include "python/interruptible.hpp"
#include "python/topics.hpp"

namespace wavecurve::python {

namespace {

SampleMode mode_of(const std::string& name) {
  if (name == "samples") return SampleMode::samples;
  if (name == "interpolate") return SampleMode::interpolate;
  throw std::invalid_argument(
      unknown_name("mode", name, std::vector<std::string>{"samples", "interpolate"}));
}

Corners corners_of(bool kept) { return kept ? Corners::kept : Corners::ignored; }

io::DrawingFile read(const std::filesystem::path& path, bool open, bool y_up) {
  return interruptible([=] { return io::read_drawing(path, {open, y_up}); });
}

std::vector<Contour> layer_contours(const io::DrawingFile& file, std::size_t layer,
                                    Eigen::Index samples, bool keep_corners) {
  return sample_layer(file.drawing.layers.at(layer), samples, corners_of(keep_corners));
}

std::vector<std::string> layer_ids(const io::DrawingFile& file) {
  std::vector<std::string> ids;
  for (const Layer& layer : file.drawing.layers) ids.push_back(layer.id);
  return ids;
}

/// A descriptor with the bank that it was made by.
struct PythonDescriptor {
  Descriptor descriptor;
  FilterBank<double> bank;
};

PythonDescriptor described(const io::DrawingFile& file, const PythonFilter& filter,
                           Eigen::Index samples, int levels, const std::string& mode,
                           bool keep_corners, bool normalized) {
  const DescriptorOptions options{samples, levels, mode_of(mode), corners_of(keep_corners),
                                  normalized};
  return interruptible([drawing = file.drawing, bank = filter.bank, options] {
    return PythonDescriptor{describe(drawing, bank, options), bank};
  });
}

py::list descriptor_layers(const PythonDescriptor& self) {
  py::list layers;
  for (const LayerDescriptor& layer : self.descriptor.layers) {
    py::list contours;
    for (const ContourDescriptor& contour : layer.contours) {
      contours.append(
          py::make_tuple(contour.coefficients, contour.closed, contour.length,
                         energy_shares(contour.coefficients, self.descriptor.options.levels)));
    }
    layers.append(py::make_tuple(layer.id, contours));
  }
  return layers;
}

std::vector<Contour> reconstructed(const PythonDescriptor& self, std::size_t layer,
                                   Eigen::Index scale) {
  return reconstruct(self.descriptor.layers.at(layer), self.bank, self.descriptor.options, scale);
}

py::tuple distance(const Contour& a, const Contour& b, const PythonFilter& filter, int levels,
                   bool closed) {
  const ShapeDistance found =
      interruptible([=, bank = filter.bank] { return shape_distance(a, b, bank, levels, closed); });
  return py::make_tuple(found.total, found.by_scale, found.shift, found.angle);
}

Eigen::MatrixXd curve_points(const WaveletCurve& curve, const Eigen::VectorXd& t, int order) {
  Eigen::MatrixXd points(t.size(), 2);
  const py::gil_scoped_release release;
  for (Eigen::Index i = 0; i < t.size(); ++i) points.row(i) = curve.derivative(t[i], order);
  return points;
}

Eigen::VectorXd curvatures(const WaveletCurve& curve, const Eigen::VectorXd& t) {
  Eigen::VectorXd values(t.size());
  const py::gil_scoped_release release;
  for (Eigen::Index i = 0; i < t.size(); ++i) values[i] = curve.curvature(t[i]);
  return values;
}

void add_drawings(py::module_& module) {
  py::class_<io::DrawingFile>(module, "NativeDrawing", "A drawing as it was read.")
      .def(py::init(&read), py::arg("path"), py::arg("open"), py::arg("y_up"))
      .def_property_readonly("warnings", [](const io::DrawingFile& f) { return f.warnings; })
      .def_property_readonly("layers", &layer_ids)
      .def_property_readonly("view_box",
                             [](const io::DrawingFile& f) {
                               const ViewBox& box = f.drawing.view_box;
                               return py::make_tuple(box.x, box.y, box.width, box.height);
                             })
      .def("contours", &layer_contours, py::arg("layer"), py::arg("samples"),
           py::arg("keep_corners"));
  py::class_<PythonDescriptor>(module, "NativeDescriptor", "A drawing's wavelet coefficients.")
      .def(py::init(&described), py::arg("drawing"), py::arg("filter"), py::arg("samples"),
           py::arg("levels"), py::arg("mode"), py::arg("keep_corners"), py::arg("normalized"))
      .def_property_readonly("layers", &descriptor_layers)
      .def("reconstruct", &reconstructed, py::arg("layer"), py::arg("scale"))
      .def("to_json",
           [](const PythonDescriptor& self) { return io::descriptor_json(self.descriptor); });
}

}  // namespace

void add_curves(py::module_& module) {
  add_drawings(module);
  module.def(
      "sample_contour",
      [](const Contour& points, Eigen::Index samples, bool keep_corners) {
        return sample_contour(points, samples, corners_of(keep_corners));
      },
      py::arg("points"), py::arg("samples"), py::arg("keep_corners"));
  module.def(
      "to_coefficients",
      [](const PythonFilter& filter, const Contour& samples, int levels, const std::string& mode) {
        return to_coefficients(filter.bank, samples, levels, mode_of(mode));
      },
      py::arg("filter"), py::arg("samples"), py::arg("levels"), py::arg("mode"));
  module.def(
      "to_samples",
      [](const PythonFilter& filter, const Contour& coefficients, int levels,
         const std::string& mode) {
        return to_samples(filter.bank, coefficients, levels, mode_of(mode));
      },
      py::arg("filter"), py::arg("coefficients"), py::arg("levels"), py::arg("mode"));
  module.def("normalized_contour", &normalized_contour, py::arg("points"));
  module.def("shape_distance", &distance, py::arg("a"), py::arg("b"), py::arg("filter"),
             py::arg("levels"), py::arg("closed"));
  module.def("elliptic_fourier_distance", &elliptic_fourier_distance, py::arg("a"), py::arg("b"),
             py::arg("harmonics"));
  module.def(
      "count_crossings",
      [](const Contour& points, bool closed) {
        return interruptible(
            [=] { return count_crossings(points, closed ? Closing::joined : Closing::open); });
      },
      py::arg("points"), py::arg("closed"));
  py::class_<WaveletCurve>(module, "NativeCurve", "f(t) = sum_n c_n phi(N t - n).")
      .def(py::init([](const PythonFilter& filter, const Contour& finest) {
             return WaveletCurve(filter.bank, finest);
           }),
           py::arg("filter"), py::arg("finest"))
      .def("derivative", &curve_points, py::arg("t"), py::arg("order"))
      .def("curvature", &curvatures, py::arg("t"));
}

}  // namespace wavecurve::python
