// The periodic wavelet transform of numpy arrays along any axis, where they lie.
#include <algorithm>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <stdexcept>
#include <string>
#include <vector>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"
#include "wavecurve/transform/transform_batch.hpp"

#include "python/filter_source.hpp"
#include "python/topics.hpp"

namespace wavecurve::python {

namespace {

namespace py = pybind11;

FilterBank<float> single_precision(const PythonFilter& filter) {
  if (const auto* name = std::get_if<std::string>(&filter.source.origin)) {
    return find_filter_bank<float>(*name);
  }
  const auto rounded = [](const Filter<double>& from) {
    return Filter<float>{from.first_index, {from.taps.begin(), from.taps.end()}};
  };
  return make_filter_bank(filter.bank.name, rounded(filter.bank.analysis_low),
                          rounded(filter.bank.synthesis_low));
}

/// A transform for arrays of either precision.
struct Transform {
  PythonFilter filter;
  PeriodicTransform<double> of_doubles;
  PeriodicTransform<float> of_floats;

  Transform(const PythonFilter& from, Eigen::Index samples, int levels)
      : filter(from),
        of_doubles(from.bank, samples, levels),
        of_floats(single_precision(from), samples, levels) {}
};

template <class Scalar>
const PeriodicTransform<Scalar>& of_scalar(const Transform& transform) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return transform.of_doubles;
  } else {
    return transform.of_floats;
  }
}

/// A dimension of the arrays beside the axis; strides count values.
struct Dimension {
  py::ssize_t size, in, out;
};

/// The dimensions beside the axis, neighbours that lie in one stride made one.
std::vector<Dimension> dimensions_beside(const py::array& x, const py::array& out, int axis) {
  const py::ssize_t value = x.itemsize();
  std::vector<Dimension> result;
  for (int i = 0; i < x.ndim(); ++i) {
    if (i == axis || x.shape(i) == 1) continue;
    const Dimension next{x.shape(i), x.strides(i) / value, out.strides(i) / value};
    if (!result.empty() && result.back().in == next.in * next.size &&
        result.back().out == next.out * next.size) {
      result.back() = {result.back().size * next.size, next.in, next.out};
    } else {
      result.push_back(next);
    }
  }
  return result;
}

/// The signals of all places beside the axis: the largest dimension as the columns of a matrix, the
/// others one after the other.
template <class Scalar>
void transform_all(const PeriodicTransform<Scalar>& transform, TransformDirection direction,
                   const Scalar* in, Scalar* out, Dimension along, std::vector<Dimension> beside,
                   int threads) {
  using Matrix = typename PeriodicTransform<Scalar>::Matrix;
  using Strides = typename PeriodicTransform<Scalar>::Strides;
  Dimension columns{1, along.size, along.size};
  if (!beside.empty()) {
    const auto largest =
        std::ranges::max_element(beside, {}, [](const Dimension& d) { return d.size; });
    columns = *largest;
    beside.erase(largest);
  }
  std::vector<py::ssize_t> place(beside.size(), 0);
  while (true) {
    const Eigen::Map<const Matrix, 0, Strides> from(in, along.size, columns.size,
                                                    Strides(columns.in, along.in));
    Eigen::Map<Matrix, 0, Strides> to(out, along.size, columns.size,
                                      Strides(columns.out, along.out));
    transform_batch<Scalar>(transform, direction, from, to, threads);
    std::size_t i = beside.size();
    while (i > 0) {
      const Dimension& d = beside[--i];
      in += d.in, out += d.out;
      if (++place[i] < d.size) break;
      in -= d.in * d.size, out -= d.out * d.size, place[i] = 0;
      if (i == 0) return;
    }
    if (beside.empty()) return;
  }
}

/// Eigen takes no negative strides, and values must stand where processors read them.
bool lies_well(const py::array& x) {
  if ((x.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) == 0) return false;
  for (int i = 0; i < x.ndim(); ++i) {
    if (x.strides(i) < 0 || x.strides(i) % x.itemsize() != 0) return false;
  }
  return true;
}

/// The memory that an array with strides that are not negative spans.
std::pair<const char*, const char*> span_of(const py::array& x) {
  const char* const begin = static_cast<const char*>(x.data());
  const char* end = begin + x.itemsize();
  for (int i = 0; i < x.ndim(); ++i) end += (x.shape(i) - 1) * x.strides(i);
  return {begin, end};
}

void check_output(const py::array& x, const py::array& out) {
  if (!out.dtype().is(x.dtype())) {
    throw std::invalid_argument(
        must_be("the dtype of out", std::string(py::str(out.dtype())),
                "that of the argument, " + std::string(py::str(x.dtype()))));
  }
  if (!out.writeable() || !lies_well(out)) {
    throw std::invalid_argument("out must be writeable, aligned and without negative strides");
  }
  bool same_layout = out.data() == x.data() && out.ndim() == x.ndim();
  for (int i = 0; i < x.ndim(); ++i) {
    if (out.ndim() != x.ndim() || out.shape(i) != x.shape(i)) {
      throw std::invalid_argument("out must have the shape of the argument");
    }
    same_layout = same_layout && (x.shape(i) == 1 || out.strides(i) == x.strides(i));
  }
  const auto [in_begin, in_end] = span_of(x);
  const auto [out_begin, out_end] = span_of(out);
  if (!same_layout && in_begin < out_end && out_begin < in_end) {
    throw std::invalid_argument("out must be the argument itself or share no memory with it");
  }
}

/// As an array of float64 or float32: what is something else, or lies badly, is copied.
py::array taken(const py::object& argument) {
  py::array x = py::array::ensure(argument);
  if (!x) throw py::type_error("the argument must be an array of real numbers");
  const char kind = x.dtype().kind();
  const bool is_float =
      x.dtype().is(py::dtype::of<double>()) || x.dtype().is(py::dtype::of<float>());
  if (!is_float) {
    if (kind != 'i' && kind != 'u' && kind != 'b' && kind != 'f') {
      throw py::type_error("the dtype of the argument is " + std::string(py::str(x.dtype())) +
                           ", but must be float64, float32 or one that numpy converts to float64");
    }
    const bool is_single = kind == 'f' && x.itemsize() == sizeof(float);  // of another byte order
    if (is_single) return py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(x);
    return py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(x);
  }
  if (lies_well(x)) return x;
  if (x.itemsize() == sizeof(double)) return py::array_t<double, py::array::c_style>::ensure(x);
  return py::array_t<float, py::array::c_style>::ensure(x);
}

template <class Scalar>
py::array applied(const Transform& self, TransformDirection direction, const py::array& x, int axis,
                  const std::optional<py::array>& given, int threads) {
  const PeriodicTransform<Scalar>& transform = of_scalar<Scalar>(self);
  if (given) check_output(x, *given);
  py::array out = given ? *given
                        : py::array(py::array_t<Scalar>(
                              std::vector<py::ssize_t>(x.shape(), x.shape() + x.ndim())));
  if (x.size() == 0) return out;
  constexpr auto value = static_cast<py::ssize_t>(sizeof(Scalar));
  const Dimension along{x.shape(axis), x.strides(axis) / value, out.strides(axis) / value};
  auto beside = dimensions_beside(x, out, axis);
  const auto* const from = static_cast<const Scalar*>(x.data());
  auto* const to = static_cast<Scalar*>(out.mutable_data());
  const py::gil_scoped_release release;
  transform_all<Scalar>(transform, direction, from, to, along, std::move(beside), threads);
  return out;
}

template <TransformDirection direction>
py::array apply(const Transform& self, const py::object& argument, int axis,
                const std::optional<py::array>& out, int threads) {
  const py::array x = taken(argument);
  const auto dimensions = static_cast<int>(x.ndim());
  if (axis < -dimensions || axis >= dimensions) {
    throw std::invalid_argument(
        dimensions == 0
            ? std::string("the argument has no axis")
            : must_be("axis", axis, "one of the argument's " + std::to_string(dimensions)));
  }
  if (axis < 0) axis += dimensions;
  check_at_least("threads", threads, 1);
  if (x.shape(axis) != self.of_doubles.samples()) {
    throw std::invalid_argument(must_be("the size along the axis", x.shape(axis),
                                        std::to_string(self.of_doubles.samples())));
  }
  return x.itemsize() == sizeof(double) ? applied<double>(self, direction, x, axis, out, threads)
                                        : applied<float>(self, direction, x, axis, out, threads);
}

constexpr const char* call_help = R"(

Parameters
----------
x : array_like
    float64 or float32, whose size along the axis is `samples`; integers become float64. It is read
    where it lies, unless its strides are negative or it is not aligned.
axis : int
    The axis along which each signal runs.
out : ndarray, optional
    Where the result goes; x itself for a transform in place.
threads : int
    Threads that share the signals, at least 1; the result is the same to the last bit.

Returns
-------
ndarray
    An array of the shape and dtype of x.

Raises
------
ValueError
    For a size that does not fit, an unknown axis, an unsuitable `out`.
TypeError
    For complex numbers and what is no number.

Notes
-----
The GIL is released.)";

template <TransformDirection direction>
void add_call(py::class_<Transform>& type, const char* name, const std::string& summary) {
  type.def(name, &apply<direction>, py::arg("x"), py::arg("axis") = -1, py::arg("out") = py::none(),
           py::arg("threads") = 1, (summary + call_help).c_str());
}

}  // namespace

void add_transform(py::module_& module) {
  py::class_<Transform> type(module, "NativeTransform",
                             "A periodic transform; wavecurve.Transform.");
  type.def(py::init<const PythonFilter&, Eigen::Index, int>(), py::arg("filter"),
           py::arg("samples"), py::arg("levels"))
      .def_property_readonly("samples", [](const Transform& t) { return t.of_doubles.samples(); })
      .def_property_readonly("levels", [](const Transform& t) { return t.of_doubles.levels(); })
      .def_property_readonly("filter", [](const Transform& t) { return t.filter; });
  add_call<TransformDirection::forward>(
      type, "forward", "Samples to coefficients in global-to-local order, S^-1 x.");
  add_call<TransformDirection::inverse>(type, "inverse",
                                        "Coefficients in global-to-local order to samples, S x.");
  add_call<TransformDirection::forward_adjoint>(type, "forward_adjoint",
                                                "The adjoint of `forward`, S^-T x.");
  add_call<TransformDirection::inverse_adjoint>(type, "inverse_adjoint",
                                                "The adjoint of `inverse`, S^T x.");
}

}  // namespace wavecurve::python
