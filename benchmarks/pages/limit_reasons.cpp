#include "limit_reasons.hpp"

#include <map>

namespace wavecurve::tracking {

std::string limit_reason(const std::string& kernel) {
  static const std::string modes =
      "The modes, not the transforms: the 1026 closed forms, of two roots, six divisions, a sine "
      "and a cosine each, take 48 % of its time (samples of perf), the Fourier transforms 10 %, "
      "the wavelet transforms 12 %. A Fourier transform of 1024 points takes 1.7 us, its "
      "arithmetic 0.9.";
  static const std::string short_transforms =
      "Products with K of 64 samples: transforms and circulant are 72 % of the time of "
      "coupled_solver, 70 % of that of implicit_solver (samples of perf); their levels are of 32 "
      "samples down to 1, where vectors are not full.";
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
      {"spectral_solver", modes},
      {"block_decoupled_solver",
       "As spectral_solver: the closed forms and their sines are 43 % of its instructions, the "
       "Fourier transforms 12 % (callgrind)."},
      {"coupled_solver", short_transforms},
      {"implicit_solver", short_transforms},
      {"conjugate_gradients",
       "31 % of its time are sums and products of vectors by Eigen, two doubles at a time, as "
       "every "
       "processor can; the rest is products with the matrix, see operator_product. Two passes less "
       "an iteration changed nothing (153 us to 155)."},
      {"schulz_inverse",
       "Eigen's matrix product is 76 % of its instructions (callgrind), on vectors of two doubles, "
       "as every processor can, where the limit is that of eight."},
      {"correspondence",
       "The three Fourier transforms are a third of its instructions (callgrind), 5 us; means, "
       "norms and moduli, which the limit leaves out, are another half, two doubles at a time."},
      {"crossings",
       "Decisions: of 46 000 branches 4 000 are guessed wrong (callgrind's simulator), at about 15 "
       "cycles each half of its time. Comparing without branches takes 8 % more instructions and "
       "no less time."},
      {"linear_frame", "A transform by sums of products, in two columns; see cdf9.7."},
  };
  const auto found = reasons.find(kernel);
  return found == reasons.end() ? "" : found->second;
}

}  // namespace wavecurve::tracking
