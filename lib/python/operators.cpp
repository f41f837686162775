// Matrices of the periodized multiscale basis, assembled and as operators; Schulz's inverse.
#include <mutex>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <string>

#include "wavecurve/dynamics/schulz_inverse.hpp"
#include "wavecurve/operators/differentiation.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"
#include "wavecurve/operators/nonstandard_form.hpp"
#include "wavecurve/operators/spectrum.hpp"
#include "wavecurve/transform/synthesis_matrix.hpp"

#include "python/filter_source.hpp"
#include "python/interruptible.hpp"
#include "python/topics.hpp"

namespace wavecurve::python {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

Sparse matrix(const PythonFilter& filter, Eigen::Index samples, int levels, int p, int q) {
  return interruptible([=, bank = filter.bank] {
    return p == 0 && q == 0 ? gram(bank, samples, levels)
                            : multiscale_matrix(bank, samples, levels, p, q);
  });
}

Sparse damping_matrix(const PythonFilter& filter, Eigen::Index samples, int levels, double s1,
                      double s2) {
  return interruptible([=, bank = filter.bank] { return damping(bank, samples, levels, s1, s2); });
}

Sparse differentiation(const PythonFilter& filter, Eigen::Index samples, int derivative,
                       bool collocation) {
  return interruptible([=, bank = filter.bank] {
    return circulant_matrix(collocation ? collocation_differentiation(bank, samples, derivative)
                                        : galerkin_differentiation(bank, samples, derivative));
  });
}

Sparse nonstandard(const PythonFilter& filter, Eigen::Index samples, int levels, int derivative) {
  return interruptible([=, bank = filter.bank] {
    return nonstandard_matrix(nonstandard_form(bank, derivative), samples, levels);
  });
}

Sparse synthesis(const PythonFilter& filter, Eigen::Index samples, int levels) {
  return interruptible([=, bank = filter.bank] { return synthesis_matrix(bank, samples, levels); });
}

/// MultiscaleOperator has one workspace, so that one thread at a time applies it.
class Operator {
 public:
  Operator(const PythonFilter& filter, Eigen::Index samples, int levels, int p, int q)
      : operator_(filter.bank, samples, levels, p, q) {}

  Eigen::Index size() const { return operator_.size(); }

  Eigen::MatrixXd apply(const Eigen::Ref<const Eigen::MatrixXd>& x) {
    Eigen::MatrixXd y(x.rows(), x.cols());
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    for (Eigen::Index j = 0; j < x.cols(); ++j) operator_.apply(x.col(j), y.col(j));
    return y;
  }

 private:
  MultiscaleOperator operator_;
  std::mutex mutex_;
};

py::tuple spectrum_ends(const PythonFilter& filter, Eigen::Index samples, int levels, int p) {
  const ExtremeEigenvalues ends = interruptible(
      [=, bank = filter.bank] { return extreme_eigenvalues(bank, samples, levels, p); });
  return py::make_tuple(ends.smallest, ends.largest);
}

Eigen::VectorXd vibrations(const PythonFilter& filter, Eigen::Index samples) {
  return interruptible([=, bank = filter.bank] { return vibration_eigenvalues(bank, samples); });
}

std::string name_of(dynamics::SchulzStatus status) {
  switch (status) {
    case dynamics::SchulzStatus::converged:
      return "converged";
    case dynamics::SchulzStatus::stagnated:
      return "stagnated";
    case dynamics::SchulzStatus::singular:
      break;
  }
  return "singular";
}

template <class Matrix>
py::dict to_python(const dynamics::SchulzInverse<Matrix>& found) {
  py::dict result;
  result["inverse"] = found.inverse;
  result["residuals"] = found.residuals;
  result["status"] = name_of(found.status);
  result["error_bound"] = found.error_bound;
  result["dropped"] = found.dropped;
  return result;
}

py::dict schulz_dense(const Eigen::MatrixXd& c, double tolerance) {
  return to_python(interruptible([=] { return dynamics::schulz_inverse(c, tolerance); }));
}

py::dict schulz_sparse(const Sparse& c, double tolerance, double threshold) {
  return to_python(
      interruptible([=] { return dynamics::schulz_inverse(c, tolerance, threshold); }));
}

}  // namespace

void add_operators(py::module_& module) {
  module.def("matrix", &matrix, py::arg("filter"), py::arg("samples"), py::arg("levels"),
             py::arg("p"), py::arg("q"));
  module.def("damping", &damping_matrix, py::arg("filter"), py::arg("samples"), py::arg("levels"),
             py::arg("s1"), py::arg("s2"));
  module.def("differentiation", &differentiation, py::arg("filter"), py::arg("samples"),
             py::arg("derivative"), py::arg("collocation"));
  module.def("nonstandard", &nonstandard, py::arg("filter"), py::arg("samples"), py::arg("levels"),
             py::arg("derivative"));
  module.def("synthesis_matrix", &synthesis, py::arg("filter"), py::arg("samples"),
             py::arg("levels"));
  module.def("spectrum_ends", &spectrum_ends, py::arg("filter"), py::arg("samples"),
             py::arg("levels"), py::arg("p"));
  module.def("vibration_eigenvalues", &vibrations, py::arg("filter"), py::arg("samples"));
  py::class_<Operator>(module, "NativeOperator",
                       "A matrix that is applied without being assembled.")
      .def(py::init<const PythonFilter&, Eigen::Index, int, int, int>(), py::arg("filter"),
           py::arg("samples"), py::arg("levels"), py::arg("p"), py::arg("q"))
      .def_property_readonly("size", &Operator::size)
      .def("apply", &Operator::apply, py::arg("x"));
  module.def("schulz_dense", &schulz_dense, py::arg("c"), py::arg("tolerance"));
  module.def("schulz_sparse", &schulz_sparse, py::arg("c"), py::arg("tolerance"),
             py::arg("threshold"));
}

}  // namespace wavecurve::python
