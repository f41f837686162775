#include "wavecurve/integrals/periodic.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve {

Eigen::VectorXd periodic_bilinear_form(const ShiftTensor<double>& integrals,
                                       const Eigen::Ref<const Eigen::VectorXd>& u,
                                       const Eigen::Ref<const Eigen::VectorXd>& v) {
  if (integrals.dimensions() != 2 || u.size() != v.size()) {
    throw std::invalid_argument(fmt::format(
        "a bilinear form has integrals of {} indices and vectors of {} and {} numbers, but must have "
        "two indices and vectors of one length",
        integrals.dimensions(), u.size(), v.size()));
  }
  const Eigen::Index n = u.size();
  const auto wrapped = [n](Eigen::Index i) { return (i % n + n) % n; };
  Eigen::VectorXd w = Eigen::VectorXd::Zero(n);
  if (n == 0) return w;
  for (int l = integrals.first[0]; l <= integrals.last(0); ++l) {
    // What v is multiplied by for this l: one sum over m, then one product with u.
    Eigen::VectorXd inner = Eigen::VectorXd::Zero(n);
    for (int m = integrals.first[1]; m <= integrals.last(1); ++m) {
      const double value = integrals.at({l, m});
      if (value == 0) continue;
      const Eigen::Index start = wrapped(m);
      inner.head(n - start) += value * v.tail(n - start);
      inner.tail(start) += value * v.head(start);
    }
    const Eigen::Index start = wrapped(l);
    w.head(n - start) += inner.head(n - start).cwiseProduct(u.tail(n - start));
    w.tail(start) += inner.tail(start).cwiseProduct(u.head(start));
  }
  return w;
}

}  // namespace wavecurve
