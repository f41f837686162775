#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace wavecurve {

/// Where one bank stands in the generated tables (filter_tables.cpp). Both low-pass filters are
/// slices of one array of taps; for an orthonormal family they are the same slice.
struct FilterTableRow {
  std::string_view name;
  int vanishing_moments, dual_vanishing_moments;
  double sobolev_exponent;
  int analysis_first_index, synthesis_first_index;
  std::size_t analysis_offset, analysis_size;
  std::size_t synthesis_offset, synthesis_size;
};

std::span<const FilterTableRow> filter_table_rows();

/// Pairs (alias, canonical name).
std::span<const std::pair<std::string_view, std::string_view>> filter_aliases();

/// All taps, each the correctly rounded one. Scalar is double or float.
template <class Scalar>
std::span<const Scalar> filter_table_taps();

}  // namespace wavecurve
