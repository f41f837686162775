#include "benchmarks/pages/limit_reasons.hpp"

#include <map>

namespace wavecurve::tracking {

std::string limit_reason(const std::string& kernel) {
  static const std::string rotations =
      "Shuffles, not arithmetic: 16 samples are 18 operations and 5 shuffles of 512 bits, which "
      "share the same units, at least 11.5 cycles. The loop alone, in the first-level cache, was "
      "measured at 16.2 to 14.9 (head of transform_benchmark.cpp, with what was tried).";
  static const std::string modes =
      "The modes, not the transforms: the 1026 closed forms, of two roots, six divisions, a sine "
      "and a cosine each, take 45 to 48 % of its time (sampled), the Fourier transforms 10 %, "
      "the wavelet transforms 12 %. A Fourier transform of 1024 points takes 1.7 µs, its "
      "arithmetic 0.9.";
  static const std::string short_transforms =
      "Products with K of 64 samples: transforms and circulant are 72 % of the time of "
      "coupled_solver, 70 % of that of implicit_solver (sampled); their levels are of 32 "
      "samples down to 1, where vectors are not full.";
  static const std::map<std::string, std::string> reasons{
      {"transform_forward", rotations},
      {"transform_inverse", rotations},
      {"transform_forward_cdf9.7",
       "No cascade of rotations, for the pair is not orthonormal: 16 products a pair of samples. "
       "74 % of its time are these sums, 20 % the parting of even and odd samples (sampled). The "
       "sums alone of 2048 pairs take 1.6 µs, their arithmetic 1.1; nearly every load of 64 bytes "
       "lies across two cache lines."},
      {"transform_batch",
       "25 % of its time go into interleaving and separating the columns, 59 % into the levels "
       "(sampled), of which the short ones cost their start: 0.25 of 0.9 ns a sample (head of "
       "transform_benchmark.cpp)."},
      {"operator_product",
       "The two transforms are 65 % of its time, the circulant between them 27 % (sampled): 2.1 µs "
       "at 4096, of which 1.3 are arithmetic. Without common loads it took 3.0: unaligned, each "
       "takes two cycles."},
      {"assembly",
       "Half of its time copies 22,000 runs of some five entries (sampled), whose lengths no "
       "processor predicts: 30,500 mispredicted branches an assembly (cachegrind), at 15 cycles "
       "each half of its time. Beyond 2^14 fresh pages take the most."},
      {"spectral_solver", modes},
      {"block_decoupled_solver",
       "As spectral_solver: the closed forms and their sines are 43 % of its instructions, the "
       "Fourier transforms 12 % (callgrind)."},
      {"coupled_solver", short_transforms},
      {"implicit_solver", short_transforms},
      {"conjugate_gradients",
       "32 % of its instructions are sums and products of vectors by Eigen, two doubles at a time, "
       "as "
       "every "
       "processor can; the rest is products with the matrix, see operator_product. Two passes less "
       "an iteration changed nothing (153 µs to 155)."},
      {"schulz_inverse",
       "Eigen's matrix product is 76 % of its instructions (callgrind), on vectors of two doubles, "
       "as every processor can, where the limit is that of eight."},
      {"correspondence",
       "The three Fourier transforms are a third of its instructions (callgrind), 5 µs; means, "
       "norms and moduli, which the limit leaves out, are another half, two doubles at a time."},
      {"crossings",
       "Decisions: of 46,000 branches 4,000 are guessed wrong (callgrind's simulator); at 15 "
       "cycles "
       "each, which is not measured, half of its time. Comparing without branches takes 8 % more "
       "instructions and "
       "no less time."},
      {"linear_frame",
       "The sums of products of a transform in two columns are 63 % of its time, see cdf9.7; the "
       "blend of the coefficients 14 %, copies of what wraps around 11 % (sampled)."},
  };
  const auto found = reasons.find(kernel);
  return found == reasons.end() ? "" : found->second;
}

}  // namespace wavecurve::tracking
