#include "wavecurve/transform/periodic_transform.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/detail/filter_pair.hpp"

namespace wavecurve {

namespace {

/// Groups pay off where starting and wrapping a level counts: they are interleaved and separated.
constexpr Eigen::Index largest_of_groups = 2048, smallest_group = 3;

/// The next whole cache line: half a vector on the next line costs two loads.
template <class Scalar>
Scalar* aligned(Scalar* pointer) {
  constexpr std::uintptr_t line = sizeof(Scalar) * group_size<Scalar>;
  const auto address = reinterpret_cast<std::uintptr_t>(pointer);
  return pointer + (line - address % line) % line / sizeof(Scalar);
}

template <class Scalar>
void copy_strided(const Scalar* from, Eigen::Index from_stride, Scalar* to, Eigen::Index to_stride,
                  Eigen::Index count) {
  for (Eigen::Index n = 0; n < count; ++n) to[n * to_stride] = from[n * from_stride];
}

}  // namespace

template <class Scalar>
struct PeriodicTransform<Scalar>::Cascade {
  using Filters = FilterPair<Scalar>;

  Eigen::Index samples;
  int levels;
  Filters analysis, synthesis;

  Layout layout_of(Eigen::Index columns) const;
  Eigen::Index workspace_size(Eigen::Index columns) const;
  void check_sizes(In input, const Out& output, const Workspace& workspace) const;
  /// All levels of one signal or of one group; output may be the input.
  void analyse(const Filters& filters, const Scalar* input, Scalar* output, Scalar* workspace,
               Layout layout) const;
  void synthesise(const Filters& filters, const Scalar* input, Scalar* output, Scalar* workspace,
                  Layout layout) const;
  /// Takes the columns, in groups or one by one, through analyse or synthesise.
  template <class Pass>
  void transform(In input, Out& output, Workspace& workspace, Pass pass) const;
};

template <class Scalar>
Layout PeriodicTransform<Scalar>::Cascade::layout_of(Eigen::Index columns) const {
  return columns >= smallest_group && samples <= largest_of_groups ? Layout::interleaved
                                                                   : Layout::single;
}

template <class Scalar>
Eigen::Index PeriodicTransform<Scalar>::Cascade::workspace_size(Eigen::Index columns) const {
  const Layout layout = layout_of(columns);
  const Eigen::Index buffer = std::max(analysis.buffer_size(layout), synthesis.buffer_size(layout));
  // The column or group, two halves of it between the levels, and room for the alignment.
  return 2 * samples * row_size<Scalar>(layout) + buffer + group_size<Scalar>;
}

template <class Scalar>
void PeriodicTransform<Scalar>::Cascade::check_sizes(In input, const Out& output,
                                                     const Workspace& workspace) const {
  if (input.rows() != samples || output.rows() != samples || input.cols() != output.cols()) {
    throw std::invalid_argument(
        fmt::format("a transform of {} samples was given {} x {} in and {} x {} out", samples,
                    input.rows(), input.cols(), output.rows(), output.cols()));
  }
  if (workspace.size() < workspace_size(input.cols())) {
    throw std::invalid_argument(fmt::format("the workspace holds {} values, but {} are needed",
                                            workspace.size(), workspace_size(input.cols())));
  }
}

template <class Scalar>
void PeriodicTransform<Scalar>::Cascade::analyse(const Filters& filters, const Scalar* input,
                                                 Scalar* output, Scalar* workspace,
                                                 Layout layout) const {
  const Eigen::Index size = samples * row_size<Scalar>(layout);
  if (levels == 0 && output != input) std::copy_n(input, size, output);
  Scalar* const halves[2] = {workspace, workspace + size / 2};
  Scalar* const buffer = workspace + size;
  // The scaling coefficients alternate between the two halves. The first level, in place, would
  // overwrite what it has still to read.
  const Scalar* fine = input;
  for (int level = 0, pass = 0; level < levels; ++pass) {
    const bool aside = fine == output;
    const Eigen::Index count = samples >> level;
    const int at_once = aside ? 1 : filters.levels_at_once(count, layout);
    const bool fused = at_once > 1 && level + at_once <= levels;
    level += fused ? at_once : 1;
    const Eigen::Index half = size >> level;
    Scalar* const c = level == levels && !aside ? output : halves[1 - pass % 2];
    Scalar* const d = aside ? halves[0] : output + half;
    if (fused) {
      filters.analyse_levels(fine, count, c, output, buffer);
    } else {
      filters.analyse(fine, count / 2, c, d, buffer, layout);
    }
    if (aside) std::copy_n(d, half, output + half);
    if (aside && level == levels) std::copy_n(c, half, output);
    fine = c;
  }
}

template <class Scalar>
void PeriodicTransform<Scalar>::Cascade::synthesise(const Filters& filters, const Scalar* input,
                                                    Scalar* output, Scalar* workspace,
                                                    Layout layout) const {
  const Eigen::Index size = samples * row_size<Scalar>(layout);
  if (levels == 0 && output != input) std::copy_n(input, size, output);
  Scalar* const halves[2] = {workspace, workspace + size / 2};
  Scalar* const buffer = workspace + size;
  // In place, the last level would overwrite what it has still to read.
  const int aside = output == input ? 1 : 0;
  const Scalar* c = input;
  for (int level = levels, pass = 0; level > 0; ++pass) {
    // Fused are the finest levels, where memory counts: whole groups of them from the last on.
    int at_once = filters.levels_at_once(samples >> aside, layout);
    const bool fused = at_once > 1 && level > aside && (level - aside) % at_once == 0 &&
                       filters.levels_at_once(samples >> (level - at_once), layout) > 1;
    if (!fused) at_once = 1;
    const Eigen::Index half = size >> level;
    level -= at_once;
    const Scalar* d = input + half;
    Scalar* const fine = level == 0 ? output : halves[pass % 2];
    if (fine == input) {
      Scalar* const free = halves[pass % 2];
      d = std::copy_n(d, half, free) - half;
      if (c == input) c = std::copy_n(c, half, halves[1 - pass % 2]) - half;
    }
    if (fused) {
      filters.synthesise_levels(c, input, samples >> level, fine, buffer);
    } else {
      filters.synthesise(c, d, samples >> (level + 1), fine, buffer, layout);
    }
    c = fine;
  }
}

template <class Scalar>
template <class Pass>
void PeriodicTransform<Scalar>::Cascade::transform(In input, Out& output, Workspace& workspace,
                                                   Pass pass) const {
  check_sizes(input, output, workspace);
  Scalar* const stage = aligned(workspace.data());
  const Eigen::Index in_inner = input.innerStride(), out_inner = output.innerStride();
  for (Eigen::Index first = 0, count; first < input.cols(); first += count) {
    const Layout layout = layout_of(input.cols() - first);
    Scalar* const rest = stage + samples * row_size<Scalar>(layout);
    const Scalar* in = input.data() + first * input.outerStride();
    Scalar* const out = output.data() + first * output.outerStride();
    if (layout == Layout::interleaved) {
      count = std::min(group_size<Scalar>, input.cols() - first);
      interleave(in, in_inner, input.outerStride(), count, samples, stage);
      pass(stage, stage, rest, layout);
      separate(stage, samples, out, out_inner, output.outerStride(), count);
      continue;
    }
    count = 1;
    Scalar* const to = out_inner == 1 ? out : stage;
    if (in_inner != 1) {
      copy_strided(in, in_inner, to, 1, samples);
      in = to;
    }
    pass(in, to, rest, layout);
    if (to != out) copy_strided(to, 1, out, out_inner, samples);
  }
}

template <class Scalar>
PeriodicTransform<Scalar>::PeriodicTransform(const FilterBank<Scalar>& bank, Eigen::Index samples,
                                             int levels)
    : samples_(samples), levels_(levels) {
  multiscale_bands(samples, levels);
  cascade_ = std::make_shared<const Cascade>(Cascade{samples,
                                                     levels,
                                                     {bank.analysis_low, bank.analysis_high},
                                                     {bank.synthesis_low, bank.synthesis_high}});
}

template <class Scalar>
Eigen::Index PeriodicTransform<Scalar>::workspace_size(Eigen::Index columns) const {
  return cascade_->workspace_size(columns);
}

template <class Scalar>
void PeriodicTransform<Scalar>::forward(In samples, Out coefficients, Workspace workspace) const {
  cascade_->transform(samples, coefficients, workspace,
                      [&c = *cascade_](auto... arguments) { c.analyse(c.analysis, arguments...); });
}

template <class Scalar>
void PeriodicTransform<Scalar>::inverse(In coefficients, Out samples, Workspace workspace) const {
  cascade_->transform(coefficients, samples, workspace, [&c = *cascade_](auto... arguments) {
    c.synthesise(c.synthesis, arguments...);
  });
}

template <class Scalar>
void PeriodicTransform<Scalar>::forward_adjoint(In coefficients, Out samples,
                                                Workspace workspace) const {
  cascade_->transform(coefficients, samples, workspace, [&c = *cascade_](auto... arguments) {
    c.synthesise(c.analysis, arguments...);
  });
}

template <class Scalar>
void PeriodicTransform<Scalar>::inverse_adjoint(In samples, Out coefficients,
                                                Workspace workspace) const {
  cascade_->transform(samples, coefficients, workspace, [&c = *cascade_](auto... arguments) {
    c.analyse(c.synthesis, arguments...);
  });
}

template class PeriodicTransform<double>;
template class PeriodicTransform<float>;

}  // namespace wavecurve
