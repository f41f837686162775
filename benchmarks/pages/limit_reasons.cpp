#include "limit_reasons.hpp"

#include <map>

namespace wavecurve::tracking {

std::string limit_reason(const std::string& kernel) {
  static const std::string fourier =
      "Nearly all of it is Fourier transforms by Eigen's module, which computes one complex number "
      "at "
      "a time: of vectors of eight doubles it can use one. FFTW would, but is GPL, and no other "
      "vectorised one is packaged.";
  static const std::map<std::string, std::string> reasons{
      {"transform_forward",
       "Shuffles, not arithmetic: 16 samples are 18 operations and 5 shuffles of 512 bits, which "
       "share the same units, at least 11.5 cycles. The loop alone, in the first-level cache, was "
       "measured at 16.2 to 14.9 (head of transform_benchmark.cpp, with what was tried)."},
      {"transform_inverse", "As transform_forward."},
      {"transform_forward_cdf9.7",
       "No cascade of rotations, for the pair is not orthonormal: 16 products a pair of samples. "
       "74 % of its time are these sums, 20 % the parting of even and odd samples (sampled). The "
       "sums alone of 2048 pairs take 1.6 us, their arithmetic 1.1; nearly every load of 64 bytes "
       "lies across two cache lines."},
      {"transform_batch",
       "25 % of its time go into interleaving and separating the columns, 59 % into the levels "
       "(sampled), of which the short ones cost their start: 0.25 of 0.9 ns a sample (head of "
       "transform_benchmark.cpp)."},
      {"operator_product",
       "The two transforms are 65 % of its time, the circulant between them 27 % (sampled): 2.1 us "
       "at 4096, of which 1.3 are arithmetic. Without common loads it took 3.0: unaligned, each "
       "takes two cycles."},
      {"assembly",
       "Half of its time copies 22,000 runs of some five entries (sampled), whose lengths no "
       "processor predicts: 30,500 mispredicted branches an assembly (cachegrind), at 15 cycles "
       "half of its time. Beyond 2^14 fresh pages take the most."},
      {"spectral_solver", fourier},
      {"correspondence", fourier},
      {"crossings",
       "Not memory but decisions: a tree of boxes is built and descended, N log N comparisons "
       "whose "
       "outcome no processor predicts."},
      {"linear_frame",
       "The sums of products of a transform in two columns are 63 % of its time, see cdf9.7; the "
       "blend of the coefficients 14 %, copies of what wraps around 11 % (sampled)."},
  };
  const auto found = reasons.find(kernel);
  return found == reasons.end() ? "" : found->second;
}

}  // namespace wavecurve::tracking
