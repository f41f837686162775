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
       "share the same units; a copy has neither. The loop alone is within 1.4 times of that bound "
       "(head of transform_benchmark.cpp, with what was tried)."},
      {"transform_inverse", "As transform_forward."},
      {"transform_forward_cdf9.7",
       "Sums of products: the pair is not orthonormal, so no cascade of rotations. Each product "
       "loads its vector anew, more than a third of its instructions are data references."},
      {"transform_batch",
       "One lane a signal needs no shuffles, but the columns must be interleaved and separated, "
       "and "
       "the short levels at the end cost their start (head of transform_benchmark.cpp)."},
      {"operator_product",
       "Two transforms, for which see above, are the greater part; the circulant between them runs "
       "over the samples once more."},
      {"assembly",
       "Each entry is added up from a coarser level's and indexed: tens of instructions a "
       "non-zero, "
       "where a copy has less than one. Beyond 2^14 fresh pages take the most."},
      {"spectral_solver", fourier},
      {"correspondence", fourier},
      {"crossings",
       "Not memory but decisions: a tree of boxes is built and descended, N log N comparisons "
       "whose "
       "outcome no processor predicts."},
      {"linear_frame", "A transform by sums of products, in two columns; see cdf9.7."},
  };
  const auto found = reasons.find(kernel);
  return found == reasons.end() ? "" : found->second;
}

}  // namespace wavecurve::tracking
