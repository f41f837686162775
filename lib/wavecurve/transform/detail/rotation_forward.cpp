#include "wavecurve/elementary/detail/highway_targets.hpp"
#include "wavecurve/transform/detail/rotation_kernels.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/detail/rotation_forward.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "wavecurve/transform/detail/rotation_chain-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

template <class L, class T>
HWY_INLINE void forward_level(const RotationCascade<T>& cascade, const T* fine, Index half, T* c,
                              T* d) {
  L level(cascade, cascade.tangents, 2 * half, half, half);
  const Index delay = 1 - cascade.size();
  cover<L>(half, [&](Index first, Index count) {
    level.forward(fine, c, d, first, count, delay - cascade.low_first, delay - cascade.high_first);
  });
}

template <int K, class T>
HWY_NOINLINE void forward(const RotationCascade<T>& cascade, const T* fine, Index half, T* c, T* d,
                          Layout layout) {
  using Wide = Level<K, Fill::along, hn::ScalableTag<T>>;
  using Single = Level<K, Fill::one, hn::CappedTag<T, 1>>;
  using Group = Level<K, Fill::across, hn::ScalableTag<T>>;
  if (layout == Layout::interleaved) {
    for (Index s = 0; s < group_size<T>; s += Group::lanes()) {
      forward_level<Group>(cascade, fine + s, half, c + s, d + s);
    }
    return;
  }
  if (half >= Wide::advance()) return forward_level<Wide>(cascade, fine, half, c, d);
  forward_level<Single>(cascade, fine, half, c, d);
}

template <int K, class T>
HWY_NOINLINE void forward_chain(const RotationCascade<T>& cascade, const T* fine, Index samples,
                                T* c, T* bands, T* rings) {
  Chain<K, T>(cascade, samples, rings).forward(fine, c, bands);
}

void forward_double(const RotationCascade<double>& cascade, const double* fine, Index half,
                    double* c, double* d, Layout layout) {
  WAVECURVE_BY_SIZE(forward, cascade, fine, half, c, d, layout)
}
void forward_float(const RotationCascade<float>& cascade, const float* fine, Index half, float* c,
                   float* d, Layout layout) {
  WAVECURVE_BY_SIZE(forward, cascade, fine, half, c, d, layout)
}
void forward_chain_double(const RotationCascade<double>& cascade, const double* fine, Index samples,
                          double* c, double* bands, double* rings) {
  WAVECURVE_BY_SIZE(forward_chain, cascade, fine, samples, c, bands, rings)
}
void forward_chain_float(const RotationCascade<float>& cascade, const float* fine, Index samples,
                         float* c, float* bands, float* rings) {
  WAVECURVE_BY_SIZE(forward_chain, cascade, fine, samples, c, bands, rings)
}

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

HWY_EXPORT(forward_double);
HWY_EXPORT(forward_float);
HWY_EXPORT(forward_chain_double);
HWY_EXPORT(forward_chain_float);

template <>
void rotate_forward(const RotationCascade<double>& cascade, const double* fine, Eigen::Index half,
                    double* c, double* d, Layout layout) {
  HWY_DYNAMIC_DISPATCH(forward_double)(cascade, fine, half, c, d, layout);
}
template <>
void rotate_forward(const RotationCascade<float>& cascade, const float* fine, Eigen::Index half,
                    float* c, float* d, Layout layout) {
  HWY_DYNAMIC_DISPATCH(forward_float)(cascade, fine, half, c, d, layout);
}

template <>
void rotate_forward_fused(const RotationCascade<double>& cascade, const double* fine,
                          Eigen::Index samples, double* c, double* bands, double* rings) {
  HWY_DYNAMIC_DISPATCH(forward_chain_double)(cascade, fine, samples, c, bands, rings);
}
template <>
void rotate_forward_fused(const RotationCascade<float>& cascade, const float* fine,
                          Eigen::Index samples, float* c, float* bands, float* rings) {
  HWY_DYNAMIC_DISPATCH(forward_chain_float)(cascade, fine, samples, c, bands, rings);
}

}  // namespace wavecurve
#endif
