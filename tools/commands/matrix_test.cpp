#include <string>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/operators/differentiation.hpp"
#include "wavecurve/operators/nonstandard_form.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using MatrixCommand = ProgramTest;

std::string figure(const std::string& text, const std::string& label) {
  const auto place = text.find(label);
  if (place == std::string::npos) return "";
  const auto first = text.find_first_not_of(' ', place + label.size());
  return text.substr(first, text.find_first_of(" \n", first) - first);
}

TEST_F(MatrixCommand, PrintsItsMeasures) {
  const FilterBank<double> bank = find_filter_bank("db4");
  const std::string galerkin = wavecurve("matrix db4 --samples 50").out;
  const auto column = galerkin_differentiation(bank, 50, 1);
  EXPECT_EQ(figure(galerkin, "non-zeros"), std::to_string(50 * (column.array() != 0).count()));
  EXPECT_EQ(figure(galerkin, "size"), "50");
  const std::string blocks = wavecurve("matrix db4 --form nonstandard --levels 3").out;
  const auto matrix = nonstandard_matrix(nonstandard_form(bank, 1), 64, 3);
  EXPECT_EQ(figure(blocks, "size"), std::to_string(matrix.rows()));
  EXPECT_EQ(figure(blocks, "non-zeros"), std::to_string(matrix.nonZeros()));
}

// Smooth functions are differentiated well by both methods, better by the one of higher order.
TEST_F(MatrixCommand, SaysHowWellASineIsDifferentiated) {
  const auto error = [&](const std::string& form) {
    const ProgramRun run = wavecurve("matrix db4 --form " + form);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return std::stod(figure(run.out, "error on sin(2 pi x)"));
  };
  const double galerkin = error("galerkin"), collocation = error("collocation");
  EXPECT_LT(collocation, 1e-2);
  EXPECT_LT(galerkin, 1e-2 * collocation);
}

TEST_F(MatrixCommand, WritesTheMatrixAndItsPicture) {
  for (const std::string form : {"galerkin", "collocation", "standard", "nonstandard"}) {
    const std::string command = "matrix db4 --samples 32 --form " + form;
    ASSERT_EQ(wavecurve(command + " -o d.mtx").exit_code, 0) << form;
    EXPECT_TRUE(io::read_file(folder_ / "d.mtx").starts_with("%%MatrixMarket")) << form;
    ASSERT_EQ(wavecurve(command + " -o d.svg").exit_code, 0) << form;
    EXPECT_NE(io::read_file(folder_ / "d.svg").find("<title"), std::string::npos) << form;
  }
}

TEST_F(MatrixCommand, RefusesBadInput) {
  expect_refusal("matrix db4 --form standard --samples 63", "63");
  expect_refusal("matrix db4 --form nonstandard --levels 0", "number of levels");
  expect_refusal("matrix db4 --levels 2", "--levels takes --form standard");
  expect_refusal("matrix cdf9.7 --form nonstandard", "not orthonormal");
  expect_refusal("matrix db2 --derivative 2", "but it must exceed 1");
  expect_refusal("matrix db4 --derivative 99", "99");
  expect_refusal("matrix db4 --form collocation --samples 100000", "but must have at most");
  expect_refusal("matrix db4 --form other", "other");
  expect_refusal("matrix db4 -o d.png", "but must be a file ending in .mtx");
}

}  // namespace
}  // namespace wavecurve::tools
