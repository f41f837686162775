#include "wavecurve/filters/basis_function.hpp"

namespace wavecurve {

std::string name_of(const BasisFunction& f) {
  constexpr int most_primes = 3;
  std::string name = f.wavelet ? "psi" : "phi";
  if (f.dual) name += "~";
  if (f.derivative > most_primes) return name + "^(" + std::to_string(f.derivative) + ")";
  return name + std::string(static_cast<std::size_t>(f.derivative), '\'');
}

}  // namespace wavecurve
