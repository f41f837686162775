#include <cmath>
#include <numbers>
#include <string>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/matrix_market.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using StiffnessCommand = ProgramTest;

/// The number behind a label of the text output.
double figure(const std::string& text, const std::string& label) {
  const auto place = text.find(label);
  if (place == std::string::npos) return std::nan("");
  return std::stod(text.substr(place + label.size()));
}

TEST_F(StiffnessCommand, PrintsItsMeasures) {
  const ProgramRun run = wavecurve("stiffness K2 --samples 256");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto k = stiffness(find_filter_bank("coif2"), 256, 8);
  EXPECT_EQ(figure(run.out, "non-zeros "), static_cast<double>(k.nonZeros()));
  EXPECT_EQ(figure(run.out, "symmetry error "), 0);
  // (2 pi)^2 up to the order of the family at this resolution and the eight digits printed.
  const double vibration = 4 * std::numbers::pi * std::numbers::pi;
  EXPECT_NEAR(figure(run.out, "first vibration eigenvalue "), vibration, 1e-5);
}

TEST_F(StiffnessCommand, WritesTheMatrixAndItsPicture) {
  ASSERT_EQ(wavecurve("stiffness db4 --samples 32 --levels 2 --output k.mtx").exit_code, 0);
  const std::string matrix = io::read_file(folder_ / "k.mtx");
  EXPECT_TRUE(matrix.starts_with("%%MatrixMarket matrix coordinate  real symmetric"))
      << matrix.substr(0, 80);
  ASSERT_EQ(wavecurve("stiffness db4 --samples 32 --levels 2 --output k.svg").exit_code, 0);
  const std::string picture = io::read_file(folder_ / "k.svg");
  EXPECT_NE(picture.find("<svg"), std::string::npos);
  EXPECT_NE(picture.find("<title"), std::string::npos);
}

TEST_F(StiffnessCommand, TakesAUsersFilter) {
  io::write_file(folder_ / "own.json", wavecurve("filter sym4 --format json").out);
  const std::string own = wavecurve("stiffness own.json --samples 64").out;
  const std::string named = wavecurve("stiffness sym4 --samples 64").out;
  EXPECT_EQ(figure(own, "largest eigenvalue "), figure(named, "largest eigenvalue "));
}

TEST_F(StiffnessCommand, RefusesBadInput) {
  expect_refusal("stiffness db4 --samples 63", "63");
  expect_refusal("stiffness db4 --samples 1", "samples is 1");
  expect_refusal("stiffness db4 --samples -4", "-4");
  expect_refusal("stiffness db4 --samples 64 --levels 7", "7");
  expect_refusal("stiffness db4 --output k.png", "but must be a file ending in .mtx");
  expect_refusal("stiffness haar", "but it must exceed 1.0");
  expect_refusal("stiffness nope", "unknown filter 'nope'; known: ");
  EXPECT_EQ(wavecurve("stiffness db4 --output missing/k.svg").exit_code, 3);
}

}  // namespace
}  // namespace wavecurve::tools
