#include "wavecurve/elementary/detail/highway_targets.hpp"
#include "wavecurve/transform/detail/rotation_kernels.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/detail/rotation_backward.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "wavecurve/transform/detail/rotation_chain-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

template <class L, class T>
HWY_INLINE void backward_level(const RotationCascade<T>& cascade, const T* c, const T* d,
                               Index half, T* fine) {
  L level(cascade, cascade.reversed_tangents, 2 * half, half, half);
  cover<L>(half, [&](Index first, Index count) {
    level.backward(c, d, fine, first, count, -cascade.low_first, -cascade.high_first);
  });
}

template <int K, class T>
HWY_NOINLINE void backward(const RotationCascade<T>& cascade, const T* c, const T* d, Index half,
                           T* fine, Layout layout) {
  using Wide = Level<K, Fill::along, hn::ScalableTag<T>>;
  using Single = Level<K, Fill::one, hn::CappedTag<T, 1>>;
  using Group = Level<K, Fill::across, hn::ScalableTag<T>>;
  if (layout == Layout::interleaved) {
    for (Index s = 0; s < group_size<T>; s += Group::lanes()) {
      backward_level<Group>(cascade, c + s, d + s, half, fine + s);
    }
    return;
  }
  if (half >= Wide::advance()) return backward_level<Wide>(cascade, c, d, half, fine);
  backward_level<Single>(cascade, c, d, half, fine);
}

template <int K, class T>
HWY_NOINLINE void backward_chain(const RotationCascade<T>& cascade, const T* c, const T* bands,
                                 Index samples, T* fine, T* rings) {
  Chain<K, T>(cascade, samples, rings).backward(c, bands, fine);
}

void backward_double(const RotationCascade<double>& cascade, const double* c, const double* d,
                     Index half, double* fine, Layout layout) {
  WAVECURVE_BY_SIZE(backward, cascade, c, d, half, fine, layout)
}
void backward_float(const RotationCascade<float>& cascade, const float* c, const float* d,
                    Index half, float* fine, Layout layout) {
  WAVECURVE_BY_SIZE(backward, cascade, c, d, half, fine, layout)
}
void backward_chain_double(const RotationCascade<double>& cascade, const double* c,
                           const double* bands, Index samples, double* fine, double* rings) {
  WAVECURVE_BY_SIZE(backward_chain, cascade, c, bands, samples, fine, rings)
}
void backward_chain_float(const RotationCascade<float>& cascade, const float* c, const float* bands,
                          Index samples, float* fine, float* rings) {
  WAVECURVE_BY_SIZE(backward_chain, cascade, c, bands, samples, fine, rings)
}

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

HWY_EXPORT(backward_double);
HWY_EXPORT(backward_float);
HWY_EXPORT(backward_chain_double);
HWY_EXPORT(backward_chain_float);

template <>
void rotate_backward(const RotationCascade<double>& cascade, const double* c, const double* d,
                     Eigen::Index half, double* fine, Layout layout) {
  HWY_DYNAMIC_DISPATCH(backward_double)(cascade, c, d, half, fine, layout);
}
template <>
void rotate_backward(const RotationCascade<float>& cascade, const float* c, const float* d,
                     Eigen::Index half, float* fine, Layout layout) {
  HWY_DYNAMIC_DISPATCH(backward_float)(cascade, c, d, half, fine, layout);
}

template <>
void rotate_backward_fused(const RotationCascade<double>& cascade, const double* c,
                           const double* bands, Eigen::Index samples, double* fine, double* rings) {
  HWY_DYNAMIC_DISPATCH(backward_chain_double)(cascade, c, bands, samples, fine, rings);
}
template <>
void rotate_backward_fused(const RotationCascade<float>& cascade, const float* c,
                           const float* bands, Eigen::Index samples, float* fine, float* rings) {
  HWY_DYNAMIC_DISPATCH(backward_chain_float)(cascade, c, bands, samples, fine, rings);
}

}  // namespace wavecurve
#endif
