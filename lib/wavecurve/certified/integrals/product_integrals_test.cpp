#include "wavecurve/certified/integrals/product_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/point_values.hpp"

namespace wavecurve::certified {
namespace {

constexpr long bits = 128;
constexpr BasisFunction phi{}, psi{.wavelet = true}, dual_phi{.dual = true};

BasisFunction derived(BasisFunction f, int order) {
  f.derivative = order;
  return f;
}
const BasisFunction slope = derived(phi, 1);

/// On the line: the first factor stands, the others are shifted.
ProductIntegral over_line(const std::vector<BasisFunction>& functions, int power = 0) {
  ProductIntegral integral{{}, power, {}};
  for (const BasisFunction& f : functions) {
    integral.factors.push_back({f, !integral.factors.empty()});
  }
  return integral;
}

ProductIntegral over(DyadicInterval interval, const std::vector<BasisFunction>& functions,
                     int power = 0) {
  ProductIntegral integral{{}, power, interval};
  for (const BasisFunction& f : functions) integral.factors.push_back({f});
  return integral;
}

ShiftTensor<Ball> integrals(const std::string& filter, const ProductIntegral& integral) {
  return product_integrals(find_filter(filter), integral, bits);
}

/// Two enclosures of one number, both narrow.
void expect_same(const Ball& a, const Ball& b) {
  EXPECT_TRUE(a.overlaps(b)) << a.to_double() << " " << b.to_double();
  EXPECT_LT(a.radius_double(), 1e-25);
  EXPECT_LT(b.radius_double(), 1e-25);
}

// Another way to the same numbers, for splines: their products are polynomials on every interval
// between multiples of 1/8, which the rule of Newton and Cotes with nine points integrates exactly
// up to degree 9.
class SplineQuadrature {
 public:
  SplineQuadrature(const std::string& filter, ProductIntegral integral)
      : integral_(std::move(integral)) {
    for (const IntegralFactor& factor : integral_.factors) {
      values_.push_back(
          dyadic_values(find_filter(filter), factor.function, points_level + factor.level, bits));
    }
  }

  Ball at(const std::vector<int>& shifts) const {
    const DyadicInterval on = integral_.interval.value_or(DyadicInterval{-20, 20, 0});
    const int scale = 1 << (points_level - on.level);
    constexpr std::array weights{989, 5888, -928, 10496, -4540, 10496, -928, 5888, 989};
    constexpr int panel = 8;
    Ball sum(0);
    for (int start = on.first * scale; start < on.last * scale; start += panel) {
      for (int i = 0; i <= panel; ++i)
        sum += Ball(weights[std::size_t(i)]) * integrand(start + i, shifts);
    }
    return sum * Ball(Rational(4, 14175)) / Ball(1 << points_level);
  }

 private:
  Ball integrand(int point, const std::vector<int>& shifts) const {
    Ball product =
        pow(Ball(Rational(point, 1 << points_level)), static_cast<unsigned long>(integral_.power));
    std::size_t next = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto& [function, shifted, level] = integral_.factors[i];
      // 2^level x - l, in units of 2^-(points_level + level).
      const int shift = shifted ? shifts[next++] << (points_level + level) : 0;
      product *= values_[i][(point << (2 * level)) - shift];
    }
    return product;
  }

  static constexpr int points_level = 6;
  ProductIntegral integral_;
  std::vector<Filter<Ball>> values_;
};

void expect_quadrature(const std::string& filter, const ProductIntegral& integral) {
  const WorkingPrecision precision(bits);
  const auto values = integrals(filter, integral);
  const SplineQuadrature quadrature(filter, integral);
  // A few tuples, the outermost included.
  const std::size_t step = std::max<std::size_t>(1, values.values.size() / 40);
  for (std::size_t place = 0; place < values.values.size(); place += step) {
    const std::vector<int> shifts = values.indices(place);
    SCOPED_TRACE(filter + " " + name_of(integral) + " " + testing::PrintToString(shifts));
    expect_same(values.values[place], quadrature.at(shifts));
  }
}

TEST(ProductIntegrals, AgreeWithTheIntegralsOfSplinePolynomials) {
  expect_quadrature("bspline3.3", over_line({slope, phi}));
  expect_quadrature("bspline3.3", over_line({phi, slope, psi}));
  expect_quadrature("bspline4.4", over_line({derived(phi, 2), phi, slope}));
  expect_quadrature("bspline2.2", over_line({phi, psi, phi, phi}));
  expect_quadrature("bspline3.1", over_line({phi, slope, phi, phi}));
}

TEST(ProductIntegrals, AgreeWithSplinePolynomialsWithPowersAndOnIntervals) {
  expect_quadrature("bspline3.3", over_line({slope, phi}, 2));
  expect_quadrature("bspline3.3", over_line({phi}, 3));
  expect_quadrature("bspline4.4", over({0, 1, 0}, {phi, derived(phi, 2)}));
  expect_quadrature("bspline4.4", over({0, 3, 0}, {slope, phi, slope}, 1));
  expect_quadrature("bspline3.3", over({-3, 5, 2}, {slope, phi}, 1));
  expect_quadrature("bspline3.3", over({1, 7, 3}, {slope, psi, phi}));
  expect_quadrature("bspline2.2", over({0, 1, 0}, {phi}, 2));
}

TEST(ProductIntegrals, AgreeWithSplinePolynomialsOnFinerLevels) {
  expect_quadrature("bspline3.3", {{{phi, false, 0}, {psi, true, 1}}});
  expect_quadrature("bspline2.2", {{{phi, false, 1}, {phi, true, 0}, {phi, true, 0}}});
  expect_quadrature("bspline3.3",
                    {{{slope, true, 1}, {slope, true, 0}}, 0, DyadicInterval{0, 1, 0}});
}

// And one for functions that are no polynomials: the trapezoidal rule with step h is off by at most
// h^2/8 int |F''|, and for F = f^3 int |F''| <= 3 |f|_sup (|f''| |f| + 2 |f'|^2) in L2 norms, with
// |f|_sup^2 <= |f| |f'|.
TEST(ProductIntegrals, AgreeWithQuadratureOnAFineGrid) {
  const WorkingPrecision precision(bits);
  const FilterDefinition db6 = find_filter("db6");
  constexpr int level = 9;
  const auto norm_squared = [&](int d) {
    return integrals("db6", over_line({derived(phi, d), derived(phi, d)})).at({0});
  };
  const Ball norm = sqrt(norm_squared(0)), norm_1 = sqrt(norm_squared(1)),
             norm_2 = sqrt(norm_squared(2));
  const Ball bound = Ball(3) * sqrt(norm * norm_1) * (norm_2 * norm + Ball(2) * norm_1 * norm_1) /
                     Ball(8L << (2 * level));
  const Filter<Ball> values = dyadic_values(db6, phi, level, bits);
  const auto cubes = integrals("db6", over_line({phi, phi, phi}));
  for (const auto& [l, m] : {std::pair{0, 0}, {1, 0}, {1, -2}, {3, 3}}) {
    Ball sum(0);
    for (int k = values.first_index; k <= values.last_index(); ++k) {
      sum += values[k] * values[k - (l << level)] * values[k - m * (1 << level)];
    }
    sum /= Ball(1 << level);
    EXPECT_TRUE(certainly_less(abs(sum - cubes.at({l, m})), bound)) << l << " " << m;
  }
  EXPECT_LT(bound.to_double(), 1e-4);
}

TEST(ProductIntegrals, CollapseToFewerFactorsByThePartitionOfUnity) {
  const WorkingPrecision precision(bits);
  for (const std::string name : {"db3", "coif1", "bspline3.3", "cdf9.7"}) {
    const auto two = integrals(name, over_line({slope, phi}));
    const auto three = integrals(name, over_line({slope, phi, phi}));
    for (int l = two.first[0]; l <= two.last(0); ++l) {
      Ball sum(0);
      for (int m = three.first[1]; m <= three.last(1); ++m) sum += three.at({l, m});
      SCOPED_TRACE(name);
      expect_same(sum, two.at({l}));
    }
  }
  const auto three = integrals("db3", over_line({slope, phi, phi}));
  const auto four = integrals("db3", over_line({slope, phi, phi, phi}));
  for (int l = -5; l <= 5; ++l) {
    for (int m = -5; m <= 5; ++m) {
      Ball sum(0);
      for (int n = four.first[2]; n <= four.last(2); ++n) sum += four.at({l, m, n});
      expect_same(sum, three.at({l, m}));
    }
  }
}

TEST(ProductIntegrals, IntegrateByPartsAndAreSymmetric) {
  const WorkingPrecision precision(bits);
  const auto first = integrals("db3", over_line({slope, phi, phi}));
  const auto second = integrals("db3", over_line({phi, slope, phi}));
  const auto third = integrals("db3", over_line({phi, phi, slope}));
  for (int l = -4; l <= 4; ++l) {
    for (int m = -4; m <= 4; ++m) {
      expect_same(first.at({l, m}) + second.at({l, m}) + third.at({l, m}), Ball(0));
      expect_same(first.at({l, m}), first.at({m, l}));
      expect_same(second.at({l, m}), third.at({m, l}));
      expect_same(first.at({l, m}), second.at({-l, m - l}));  // x -> x + l
    }
  }
}

TEST(ProductIntegrals, AreMuAndNuForTwoFactors) {
  const WorkingPrecision precision(bits);
  for (const std::string name : {"db3", "db6", "coif2", "bspline4.4", "cdf9.7"}) {
    for (const auto& [p, q] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
      const auto known = connection_coefficients(find_filter(name), p, q, bits);
      // mu_l = int phi^(p)(x - l) phi^(q)(x): the factor at rest comes first here.
      const auto low = integrals(name, over_line({derived(phi, q), derived(phi, p)}));
      const auto high = integrals(name, over_line({derived(psi, q), derived(psi, p)}));
      for (int l = -30; l <= 30; ++l) {
        EXPECT_TRUE(low.at({l}).overlaps(known.mu[l])) << name << " " << p << q << " " << l;
        EXPECT_TRUE(high.at({l}).overlaps(known.nu[l])) << name << " " << p << q << " " << l;
      }
    }
  }
}

TEST(ProductIntegrals, HaveBeylkinsExactValuesForD6) {
  // r_l = int phi(x - l) phi'(x) dx (Beylkin 1992, Table 1), here of the opposite sign: his filter
  // is ours reversed.
  const auto r = integrals("db3", over_line({slope, phi}));
  const Rational known[] = {Rational(0), Rational(-272, 365), Rational(53, 365),
                            Rational(-16, 1095), Rational(-1, 2920)};
  const bool reversed = r.at({1}).contains(-known[1]);
  for (int l = 0; l <= 4; ++l) {
    EXPECT_TRUE(r.at({reversed ? -l : l}).contains(known[l])) << l;
    EXPECT_TRUE(r.at({reversed ? l : -l}).contains(-known[l])) << l;
  }
}

TEST(ProductIntegrals, TheTwoSidesAreBiorthogonalOnAllLevels) {
  const WorkingPrecision precision(bits);
  const auto delta = integrals("cdf9.7", over_line({phi, dual_phi}));
  const auto zero = integrals("cdf9.7", over_line({psi, dual_phi}));
  const auto finer = integrals("cdf9.7", {{{dual_phi, false, 0}, {psi, true, 2}}});
  for (int l = -8; l <= 8; ++l) {
    expect_same(delta.at({l}), Ball(l == 0 ? 1 : 0));
    expect_same(zero.at({l}), Ball(0));
    expect_same(finer.at({l}), Ball(0));
  }
}

TEST(ProductIntegrals, ScaleWithTheirArgument) {
  // int f(2x - l) g(2x - m) h(2x) dx = 1/2 int f(x - l) g(x - m) h(x) dx
  const WorkingPrecision precision(bits);
  ProductIntegral fine = over_line({phi, slope, psi});
  const auto coarse = integrals("db4", fine);
  for (IntegralFactor& factor : fine.factors) factor.level = 1;
  const auto halved = integrals("db4", fine);
  for (int l = -3; l <= 3; ++l) {
    for (int m = -3; m <= 3; ++m) {
      expect_same(halved.at({l, m}), coarse.at({l, m}) / Ball(2));
    }
  }
}

TEST(ProductIntegrals, OnIntervalsAddUpToTheLine) {
  const WorkingPrecision precision(bits);
  for (const auto& functions : {std::vector{slope, phi}, {phi, psi, slope}}) {
    // psi of D6 lives on [-2, 3], phi on [0, 5].
    const auto line = integrals("db3", over_line(functions));
    const auto all = integrals("db3", over({-10, 10, 0}, functions));
    const auto left = integrals("db3", over({-10, 5, 1}, functions));
    const auto right = integrals("db3", over({5, 20, 1}, functions));
    for (std::size_t place = 0; place < line.values.size(); ++place) {
      std::vector<int> shifts = line.indices(place);
      shifts.insert(shifts.begin(), 0);
      expect_same(line.values[place], all.at(shifts));
    }
    EXPECT_THROW(integrals("db3", over({0, -1, 0}, functions)), std::invalid_argument);
    for (std::size_t place = 0; place < right.values.size(); ++place) {
      const std::vector<int> shifts = right.indices(place);
      const bool inside =
          std::all_of(shifts.begin(), shifts.end(), [](int l) { return l >= -5 && l <= 7; });
      // [-10, 5] in halves is [-5, 2.5].
      if (!inside || shifts[0] != 0) continue;
      expect_same(integrals("db3", over({-20, 20, 1}, functions)).at(shifts),
                  left.at(shifts) + right.at(shifts));
      break;
    }
  }
}

TEST(ProductIntegrals, OnAnIntervalObeyTheFundamentalTheorem) {
  // int_0^1 (phi(x - l) phi(x - m))' dx is the difference of the products at its ends.
  const WorkingPrecision precision(bits);
  const auto left = integrals("db3", over({0, 1, 0}, {slope, phi}));
  const auto values = dyadic_values(find_filter("db3"), phi, 0, bits);
  for (int l = -4; l <= 0; ++l) {
    for (int m = -4; m <= 0; ++m) {
      expect_same(left.at({l, m}) + left.at({m, l}),
                  values[1 - l] * values[1 - m] - values[-l] * values[-m]);
    }
  }
}

TEST(ProductIntegrals, PowersAloneGiveMoments) {
  const WorkingPrecision precision(bits);
  for (const BasisFunction& f : {phi, dual_phi, BasisFunction{.wavelet = true, .dual = true}}) {
    const auto known = moments(find_filter("cdf9.7"), f, 6, 200);
    for (int p = 0; p <= 6; ++p) {
      expect_same(integrals("cdf9.7", over_line({f}, p)).at(std::initializer_list<int>{}),
                  known[static_cast<std::size_t>(p)]);
    }
  }
}

TEST(ProductIntegrals, CollapseToMomentsForPowersWithTwoFactors) {
  // sum_l phi(x - l) = 1.
  const WorkingPrecision precision(bits);
  const auto known = moments(find_filter("db4"), phi, 3, 200);
  const auto values = integrals("db4", over_line({phi, phi}, 3));
  Ball sum(0);
  for (const Ball& value : values.values) sum += value;
  expect_same(sum, known[3]);
}

TEST(ProductIntegrals, ReachThePrecisionAskedFor) {
  for (const long asked : {60L, 500L, 4000L}) {
    const auto values = product_integrals(find_filter("db3"), over_line({slope, phi, phi}), asked);
    const WorkingPrecision precision(asked + 64);
    Ball largest_radius(0);
    for (const Ball& value : values.values) {
      if (certainly_less(largest_radius, value.radius())) largest_radius = value.radius();
    }
    EXPECT_TRUE(certainly_less(largest_radius, Ball(Rational::power_of_two(-asked)))) << asked;
  }
}

std::string refusal(const std::string& filter, const ProductIntegral& integral) {
  try {
    integrals(filter, integral);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ProductIntegrals, RefuseWhatIsNotKnownToExist) {
  const auto contains = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  contains(refusal("db2", over_line({slope, derived(psi, 1)})),
           "its Sobolev exponent is 1.000, but it must exceed 1.0");
  contains(refusal("db2", over_line({slope, slope, phi})), "but it must exceed 1.0");
  // For phi' alone on an interval, half a derivative less is enough.
  contains(refusal("db1", over({0, 1, 0}, {slope})), "but it must exceed 0.5");
  contains(refusal("db2", over({0, 1, 0}, {derived(phi, 2), phi})), "but it must exceed 1.5");
  contains(refusal("bspline3.1", over_line({phi, derived(dual_phi, 3)})), "add up to");
  contains(refusal("db9", over_line({derived(phi, 9), phi})), "from 0 to 8");
  contains(refusal("db3", over_line({phi, phi, phi, phi, phi})), "from 1 to 4");
  contains(refusal("db3", over({0, 1, 0}, {phi, phi, phi, phi})), "from 1 to 3");
  contains(refusal("db3", over({0, 1, 11}, {phi, phi})), "from 0 to 10");
  contains(refusal("db3", over({1, 1, 0}, {phi, phi})), "the interval from 1 to 1 is empty");
  contains(refusal("db3", over({3, 2, 1}, {phi, phi})), "the interval from 3/2 to 1 is reversed");
  contains(refusal("db38", over_line({phi, slope, phi})), "number of unknown integrals");
  contains(refusal("db3", over({0, 100000, 0}, {phi, phi})), "number of integrals");
}

}  // namespace
}  // namespace wavecurve::certified
