#include "wavecurve/certified/sobolev_exponent.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/decimal_enclosure.hpp"
#include "wavecurve/certified/detail/ball_matrix.hpp"
#include "wavecurve/certified/detail/eigenfunction_bound.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve::certified {

namespace {

/// q(x) of low(x) = sqrt 2 ((1 + x)/2)^N q(x), by repeated division by (1 + x)/2.
std::vector<Ball> without_zeros_at_pi(const Filter<Ball>& low, int zeros_at_pi) {
  std::vector<Ball> quotient = low.taps;
  const Ball root_two = sqrt(Ball(2));
  for (Ball& tap : quotient) tap /= root_two;
  for (int i = 0; i < zeros_at_pi; ++i) {
    for (std::size_t k = 1; k < quotient.size(); ++k) quotient[k] -= quotient[k - 1];
    if (!quotient.back().contains_zero()) {
      throw std::domain_error("the filter has fewer than " + std::to_string(zeros_at_pi) +
                              " zeros at pi: remainder " + magnitude_bound(quotient.back()));
    }
    quotient.pop_back();
    for (Ball& c : quotient) c *= Ball(2);
  }
  return quotient;
}

/// T on symmetric sequences u_0 .. u_{n-1}, n = deg q (at least 1).
SquareMatrix<Ball> transition_operator(const std::vector<Ball>& q) {
  const int degree = static_cast<int>(q.size()) - 1;
  const auto a = [&](int k) {
    Ball sum(0);
    if (k < 0) k = -k;
    for (int i = 0; i + k <= degree; ++i) {
      sum += q[static_cast<std::size_t>(i)] * q[static_cast<std::size_t>(i + k)];
    }
    return sum;
  };
  std::vector<Ball> table;
  for (int k = 0; k <= 3 * degree + 1; ++k) table.push_back(a(k));
  const auto at = [&](int k) { return table[static_cast<std::size_t>(k < 0 ? -k : k)]; };
  const int n = degree < 1 ? 1 : degree;
  SquareMatrix<Ball> t(n);
  for (int i = 0; i < n; ++i) {
    t(i, 0) = Ball(2) * at(2 * i);
    for (int j = 1; j < n; ++j) t(i, j) = Ball(2) * (at(2 * i - j) + at(2 * i + j));
  }
  return t;
}

constexpr long rough_bits = 128;                // enough for the few squarings that mostly decide
constexpr long bits_of_an_eigenfunction = 192;  // which may be small somewhere
constexpr int most_squarings = 45;              // leave a radius of 1e-13 for the longest filters
constexpr double accurate_radius = 1e-13;

/// What the squarings of all attempts together may take, in products of entries times bits: about
/// a second. The families take at most a third of it. One's own filter with hundreds of taps beyond
/// its zeros takes all of it, and gets the enclosure that is reached by then.
class Work {
 public:
  bool affords_squaring(int size, long bits) {
    left_ -= std::pow(size, 3) * static_cast<double>(bits);
    return left_ > 0;
  }

 private:
  double left_ = 1.2e10;
};

Ball norm_of(const BallMatrix& matrix) {
  Ball norm;
  arb_mat_frobenius_norm(norm.get(), matrix.value, WorkingPrecision::bits());
  return norm;
}

/// log rho of T from T^k, k = 2^squarings: |tr T^k| / n <= rho^k <= norm(T^k), and 1 <= rho.
/// T maps non-negative functions to such, so that rho itself is an eigenvalue and the trace is
/// mostly no small sum of large terms; the two bounds differ by a factor that the k-th root brings
/// to 1. rho is at least 1 since (T u)(0) >= |q(0)|^2 u(0) = u(0).
std::optional<Ball> log_spectral_radius(const BallMatrix& power, int size, int squarings) {
  Ball trace, lower(0);
  arb_mat_trace(trace.get(), power.value, WorkingPrecision::bits());
  const Ball norm = norm_of(power);
  if (certainly_less(Ball(size), trace)) lower = log(trace / Ball(size));
  const Ball log_rho = hull(lower, log(norm)) * Ball(Rational::power_of_two(-squarings));
  return log_rho.is_finite() ? std::optional(log_rho) : std::nullopt;
}

using Enough = std::function<bool(const Ball& exponent)>;

/// Whether an eigenfunction may tell what some squarings do not. Where it is not positive it is not at
/// any precision, and left out from then on.
enum class Eigenfunction { used, left_out };

/// The exponent as far as one attempt came, and whether it ended because the powers had become too
/// wide.
struct Attempt {
  std::optional<Ball> exponent;
  bool lost_precision = false;
};

/// The exponent s of a filter with `all_zeros` zeros at pi of which only `zeros` are divided out.
/// T then has the largest eigenvalue max(1, 4^(zeros - s)), and tells min(zeros, s).
Ball exponent_from(const Ball& told, int zeros, int all_zeros) {
  if (zeros == all_zeros || certainly_less(told, Ball(zeros))) return told;
  return hull(told, Ball(all_zeros));
}

/// Each power T^k, k = 1, 2, 4, ..., encloses the exponent. Their intersection is kept until it is
/// enough, or until the errors of the k-th power widen it more than the k-th root narrows it.
Attempt exponent_by_squaring(const Filter<Ball>& low, int zeros, int all_zeros, int squarings,
                             Work& work, const Enough& enough, Eigenfunction& eigenfunction) {
  const auto t = transition_operator(without_zeros_at_pi(low, zeros));
  const long bits = WorkingPrecision::bits();
  BallMatrix power(t);
  std::optional<Ball> best;
  const auto ended = [&](bool lost_precision) {
    return Attempt{best ? std::optional(exponent_from(*best, zeros, all_zeros)) : std::nullopt,
                   lost_precision};
  };
  // The first enclosures are rough, and their logarithms would cost more than the squarings.
  constexpr int first_telling = 4;
  constexpr int rough_squarings = 8;
  double last_radius = HUGE_VAL;  // by squaring
  const auto narrow = [&](const Ball& log_rho) {
    const Ball s = Ball(zeros) - log_rho / log(Ball(4));
    if (!best) best = s;
    arb_intersection(best->get(), best->get(), s.get(), bits);
    return s.radius_double();
  };
  for (int m = 0;; ++m) {
    if (m > 0 && m < first_telling && m < squarings) {
      arb_mat_sqr(power.value, power.value, bits);
      continue;
    }
    if (const auto log_rho = log_spectral_radius(power, t.size(), m)) {
      const double radius = narrow(*log_rho);
      if (last_radius <= radius) return ended(true);
      last_radius = radius;
      if (enough(exponent_from(*best, zeros, all_zeros))) return ended(false);
      if (m == rough_squarings && eigenfunction == Eigenfunction::used) {
        // rho is at least 1.
        const auto rho = spectral_radius_by_eigenfunction(t);
        if (rho && rho->is_positive()) narrow(log(*rho));
        if (!rho) eigenfunction = Eigenfunction::left_out;
        if (enough(exponent_from(*best, zeros, all_zeros))) return ended(false);
      }
    } else if (best || norm_of(power).accuracy_bits() <= 0) {
      return ended(true);
    }
    if (m == squarings || !work.affords_squaring(t.size(), bits)) return ended(false);
    arb_mat_sqr(power.value, power.value, bits);
  }
}

constexpr const char* not_enclosed =
    "the spectral radius of the transition operator was not enclosed";

/// What keeps the exponent of a filter from being known better.
std::string limit_of(const FilterDefinition& definition) {
  return definition.known_bits ? "its taps have too few digits" : "the work is bounded";
}

/// The exponent of phi, at rising precision until it is enough.
Ball exponent_of(const FilterDefinition& definition, long family_bits, const Enough& enough) {
  const long first_bits = definition.known_bits ? 128 : family_bits;
  Work work;
  Eigenfunction eigenfunction = Eigenfunction::used;
  std::optional<Ball> best;
  std::string reason = not_enclosed;
  const auto narrow = [&](const Ball& s) {
    if (!best) best = s;
    arb_intersection(best->get(), best->get(), s.get(), WorkingPrecision::bits());
  };
  const auto attempt = [&](long bits) {
    const FilterBank<Ball> bank = definition.bank(bits);
    const int all_zeros = bank.vanishing_moments;
    // Each zero that is divided out multiplies the errors of the taps, and no more are needed than
    // s. Without errors all at once take least work.
    bool lost_precision = true, is_told = false;
    for (int zeros = definition.known_bits ? std::min(1, all_zeros) : all_zeros; zeros <= all_zeros;
         ++zeros) {
      const double before = best ? best->radius_double() : 0;
      const Attempt found = exponent_by_squaring(bank.synthesis_low, zeros, all_zeros,
                                                 most_squarings, work, enough, eigenfunction);
      if (found.exponent) narrow(*found.exponent);
      lost_precision = found.lost_precision;
      if (!best) continue;
      if (enough(*best)) break;
      // The next after s tells more than s itself, beside which the 1 is as large.
      if (is_told && !(best->radius_double() < before)) break;
      is_told |= certainly_less(*best, Ball(zeros));
    }
    return !lost_precision;
  };
  try {
    refine(first_bits, attempt, definition.known_bits);
  } catch (const std::domain_error& error) {
    reason = error.what();
  }
  if (best) return *best;
  throw std::domain_error("the Sobolev exponent of filter " + definition.name + " is not known (" +
                          limit_of(definition) + "): " + reason);
}

bool is_accurate(const Ball& exponent) { return exponent.radius_double() < accurate_radius; }

}  // namespace

Ball sobolev_exponent(const Filter<Ball>& low, int zeros_at_pi, int squarings) {
  Work work;
  Eigenfunction eigenfunction = Eigenfunction::left_out;
  const auto never = [](const Ball&) { return false; };
  const Attempt attempt =
      exponent_by_squaring(low, zeros_at_pi, zeros_at_pi, squarings, work, never, eigenfunction);
  if (attempt.exponent) return *attempt.exponent;
  throw std::domain_error(not_enclosed);
}

Ball sobolev_exponent(const FilterDefinition& definition) {
  return exponent_of(definition, bits_of_an_eigenfunction, is_accurate);
}

bool is_proved_smoother(const FilterDefinition& definition, const Rational& exponent) {
  const Ball found = exponent_of(definition, rough_bits, [&](const Ball& s) {
    return !s.contains(exponent) || is_accurate(s);
  });
  return certainly_less(Ball(exponent), found);
}

void require_smoothness(const FilterDefinition& definition, int p, int q) {
  const Rational needed(p + q, 2);
  constexpr int shown = 4;
  constexpr double shown_radius = 1e-5;
  // A rough bound mostly proves that a filter is smooth enough; the exponent of one that is not is
  // shown.
  const Ball found = exponent_of(definition, rough_bits, [&](const Ball& s) {
    if (certainly_less(Ball(needed), s) || is_accurate(s)) return true;
    return certainly_less(s, Ball(needed)) && s.radius_double() < shown_radius;
  });
  if (certainly_less(Ball(needed), found)) return;
  const bool is_decided = certainly_less(found, Ball(needed)) || is_accurate(found);
  const DecimalEnclosure exponent = supported_decimal(found, shown);
  throw std::domain_error(fmt::format(
      "filter {} is not {} for derivatives {},{}: its Sobolev exponent is {}, but it must exceed "
      "{}",
      definition.name, is_decided ? "smooth enough" : "known to be smooth enough", p, q,
      is_decided
          ? exponent.value
          : fmt::format("{} +- {} ({})", exponent.value, exponent.radius, limit_of(definition)),
      round_to_decimals(needed, 1)));
}

}  // namespace wavecurve::certified
