#include "wavecurve/dynamics/lagrange_system.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(CirculantSymbol, IsTheEigenvaluesAtEveryFrequency) {
  for (const char* filter : {"db4", "coif2", "cdf9.7"}) {
    for (const int order : {0, 1}) {
      for (const Eigen::Index samples : {1, 2, 8, 1024, 1 << 14}) {
        const auto mu = connection_coefficients(find_filter_bank<double>(filter), order, order).mu;
        const Eigen::VectorXd symbol = circulant_symbol(mu, samples, 2 * order);
        const Eigen::VectorXd eigenvalues = circulant_eigenvalues(mu, samples, 2 * order);
        for (Eigen::Index k = 0; k < symbol.size() && k < samples; ++k) {
          // Each addition of angles adds an error of one unit or two; there are up to 20.
          EXPECT_NEAR(symbol[k], eigenvalues[k], 100 * epsilon * eigenvalues[k])
              << filter << order << " " << samples << " " << k;
        }
      }
    }
  }
}

TEST(LagrangeSystem, HasTheDiagonalsOfItsMatricesBandByBand) {
  for (const char* filter : {"db4", "bspline4.4"}) {
    for (const int levels : {0, 2, 5}) {
      const LagrangeSystem system(find_filter_bank<double>(filter), 32, levels,
                                  {.density = 2,
                                   .stiffness = 0.7,
                                   .mass_damping = 0.3,
                                   .stiffness_damping = 1e-3,
                                   .damping_density = 0.4});
      const CirculantEigenvalues diagonals = system.band_diagonals();
      Eigen::Index i = 0;
      for (const Band& band : multiscale_bands(32, levels)) {
        for (const auto& [matrix, entries] : {std::pair(system.mass(), diagonals.mass),
                                              {system.damping(), diagonals.damping},
                                              {system.stiffness(), diagonals.stiffness}}) {
          const double expected = matrix.coeff(band.offset, band.offset);
          EXPECT_NEAR(entries[i], expected, 1e3 * epsilon * (1 + expected)) << filter << levels;
        }
        ++i;
      }
    }
  }
}

}  // namespace
}  // namespace wavecurve::dynamics
