#include "wavecurve/certified/detail/families/halfband_roots.hpp"

#include <algorithm>

#include "wavecurve/certified/detail/flint_roots.hpp"

namespace wavecurve::certified {

namespace {

class ComplexVector {
 public:
  explicit ComplexVector(long size) : values_(_acb_vec_init(size)), size_(size) {}
  ComplexVector(const ComplexVector&) = delete;
  ComplexVector& operator=(const ComplexVector&) = delete;
  ~ComplexVector() { _acb_vec_clear(values_, size_); }
  acb_ptr operator[](long i) { return values_ + i; }
  acb_ptr data() { return values_; }

 private:
  acb_ptr values_;
  long size_;
};

/// All roots of P_N(y) to the working precision.
void isolate_roots(int order, ComplexVector& roots) {
  fmpz_poly_t p;
  fmpz_poly_init(p);
  const auto coefficients = halfband_polynomial(order);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    fmpz_poly_set_coeff_fmpz(p, static_cast<slong>(k), fmpq_numref(coefficients[k].get()));
  }
  arb_fmpz_poly_complex_roots(roots.data(), p, 0, WorkingPrecision::bits());
  fmpz_poly_clear(p);
}

/// The z inside the unit circle with z + 1/z = 2 - 4y, that is z = w - sqrt(w^2 - 1), w = 1 - 2y.
/// w^2 - 1 never touches the branch cut, since P_N has no root in (0, 1).
void root_inside(acb_t z, const acb_t y) {
  const long bits = WorkingPrecision::bits();
  acb_t w, s;
  acb_init(w);
  acb_init(s);
  acb_mul_si(w, y, -2, bits);
  acb_add_si(w, w, 1, bits);
  acb_mul(s, w, w, bits);
  acb_sub_si(s, s, 1, bits);
  acb_sqrt(s, s, bits);
  acb_add(z, w, s, bits);
  Ball modulus;
  acb_abs(modulus.get(), z, bits);
  if (certainly_less(modulus, Ball(1))) acb_sub(z, w, s, bits);
  acb_inv(z, z, bits);  // from the root outside, which carries no cancellation
  acb_clear(w);
  acb_clear(s);
}

Ball real_part(const acb_t x) {
  Ball part;
  arb_set(part.get(), acb_realref(x));
  return part;
}

Ball imaginary_part(const acb_t x) {
  Ball part;
  arb_set(part.get(), acb_imagref(x));
  return part;
}

/// 1 - z x, or for a conjugate pair (1 - z x)(1 - conj(z) x).
Polynomial<Ball> factor_of(const acb_t z, bool is_real) {
  const Ball re = real_part(z), im = imaginary_part(z);
  if (is_real) return {Ball(1), -re};
  return {Ball(1), -(re + re), re * re + im * im};
}

Polynomial<Ball> factor_in_x(const acb_t y, bool is_real) {
  acb_t z;
  acb_init(z);
  root_inside(z, y);
  Polynomial<Ball> factor = factor_of(z, is_real);
  acb_clear(z);
  Ball sum(0);
  for (const Ball& c : factor) sum += c;
  for (Ball& c : factor) c /= sum;
  return factor;
}

Polynomial<Ball> factor_in_y(const acb_t y, bool is_real) {
  acb_t inverse;
  acb_init(inverse);
  acb_inv(inverse, y, WorkingPrecision::bits());
  Polynomial<Ball> factor = factor_of(inverse, is_real);
  acb_clear(inverse);
  return factor;
}

/// factor(y, is_real) for every real root y of P_N and one of each conjugate pair, in the order of
/// the header.
template <class Factor>
std::vector<Polynomial<Ball>> factors_of_halfband(int order, Factor factor) {
  const long degree = order - 1;
  if (degree < 1) return {};
  ComplexVector roots(degree);
  isolate_roots(order, roots);
  std::vector<long> chosen;
  for (long i = 0; i < degree; ++i) {
    if (acb_is_real(roots[i]) || arb_is_positive(acb_imagref(roots[i]))) chosen.push_back(i);
  }
  std::stable_sort(chosen.begin(), chosen.end(), [&](long a, long b) {
    const bool a_real = acb_is_real(roots[a]) != 0, b_real = acb_is_real(roots[b]) != 0;
    if (a_real != b_real) return a_real;
    return arb_lt(acb_realref(roots[a]), acb_realref(roots[b])) != 0;
  });
  std::vector<Polynomial<Ball>> factors;
  for (const long i : chosen) factors.push_back(factor(roots[i], acb_is_real(roots[i]) != 0));
  return factors;
}

}  // namespace

std::vector<Polynomial<Ball>> halfband_factors(int order) {
  return factors_of_halfband(order, factor_in_x);
}

std::vector<Polynomial<Ball>> halfband_factors_in_y(int order) {
  return factors_of_halfband(order, factor_in_y);
}

}  // namespace wavecurve::certified
