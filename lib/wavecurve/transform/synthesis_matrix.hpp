#pragma once

#include <Eigen/SparseCore>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The matrix S of the inverse transform: samples = S coefficients, coefficients in global-to-local
/// order (see Band). Its columns are the periodized basis functions in terms of the finest scaling
/// functions; of an orthonormal family it is orthogonal. Publication, (2.9) and (3.7).
/// Throws as multiscale_bands does.
Eigen::SparseMatrix<double> synthesis_matrix(const FilterBank<double>& bank, Eigen::Index samples,
                                             int levels);

}  // namespace wavecurve
