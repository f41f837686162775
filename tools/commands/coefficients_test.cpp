#include <cstdio>

#include <nlohmann/json.hpp>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "tools/commands/program_test.hpp"

namespace wavecurve::tools {
namespace {

using CoefficientsCommand = ProgramTest;
using certified::Rational;
using nlohmann::json;

TEST_F(CoefficientsCommand, JsonHoldsValueRadiusAndFraction) {
  const json document = json::parse(wavecurve("coefficients db3 --format json").out);
  EXPECT_EQ(document["filter"], "db3");
  EXPECT_EQ(document["derivatives"], json::parse("[1, 1]"));
  EXPECT_EQ(document["normalization"], "none");
  EXPECT_EQ(document["mu"][0]["exact"], "295/56");
  EXPECT_EQ(document["alpha"].size(), 6U);
  for (const auto& entry : document["mu"]) {
    const Rational exact = (*exact_connection_coefficients(certified::find_filter("db3"), 1, 1))
                               .mu[entry["index"].get<int>()];
    const auto error = (exact - Rational::from_decimal(entry["value"].get<std::string>())).abs();
    EXPECT_LE(error, Rational::from_decimal(entry["radius"].get<std::string>()));
  }
}

TEST_F(CoefficientsCommand, IrrationalNumbersHaveNoFraction) {
  const json document = json::parse(wavecurve("coefficients K2 --format json --digits 20").out);
  EXPECT_TRUE(document["mu"][0]["exact"].is_null());
  const auto mu = connection_coefficients(certified::find_filter("coif2"), 1, 1, 200).mu;
  for (const auto& entry : document["mu"]) {
    EXPECT_EQ(entry["value"], *certified::round_to_digits(mu[entry["index"].get<int>()], 20));
  }
  EXPECT_EQ(document["alpha"][2]["exact"], "0");
}

TEST_F(CoefficientsCommand, NormalizeDividesByTheFirst) {
  const json document =
      json::parse(wavecurve("coefficients db3 --normalize first --format json").out);
  EXPECT_EQ(document["normalization"], "first");
  EXPECT_EQ(document["mu"][0]["exact"], "1");
  EXPECT_EQ(document["mu"][4]["exact"], "-3/2950");
  EXPECT_EQ(document["alpha"][0]["exact"], "2");
}

TEST_F(CoefficientsCommand, OtherDerivativesAreComputed) {
  const json mass = json::parse(wavecurve("coefficients db2 --derivatives 0,0 --format json").out);
  EXPECT_EQ(mass["mu"][0]["exact"], "1");
  EXPECT_EQ(mass["mu"][1]["exact"], "0");
  const json advection =
      json::parse(wavecurve("coefficients db3 --derivatives 0,1 --format json").out);
  EXPECT_EQ(advection["mu"][0]["exact"], "0");
  EXPECT_EQ(advection["mu"][1]["exact"], "-272/365");  // Beylkin 1992, Table 1
}

TEST_F(CoefficientsCommand, AUsersFilterGivesWhatItsDigitsSupport) {
  io::write_file(folder_ / "own.json", wavecurve("filter db4 --format json --digits 15").out);
  const json own = json::parse(wavecurve("coefficients own.json --format json").out);
  const Rational truth =
      (*exact_connection_coefficients(certified::find_filter("db4"), 1, 1)).mu[0];
  const auto& entry = own["mu"][0];
  const auto error = (truth - Rational::from_decimal(entry["value"].get<std::string>())).abs();
  EXPECT_LE(error, Rational::from_decimal(entry["radius"].get<std::string>()));
  EXPECT_LE(Rational::from_decimal(entry["radius"].get<std::string>()),
            Rational::from_decimal("1e-9"));
}

TEST_F(CoefficientsCommand, TheHeaderCompiles) {
  io::write_file(folder_ / "c.hpp", wavecurve("coefficients bspline4.4 --format cpp").out);
  io::write_file(folder_ / "main.cpp",
                 "#include \"c.hpp\"\nstatic_assert(wavecurve_tables::bspline4_4::mu[3] < 0);\nint "
                 "main() {}\n");
  const ProgramRun built =
      run("c++ -std=c++17 -Wall -Wextra -Werror -o '" + (folder_ / "a.out").string() + "' '" +
          (folder_ / "main.cpp").string() + "'");
  EXPECT_EQ(built.exit_code, 0) << built.err;
}

TEST_F(CoefficientsCommand, RefusesBadInput) {
  expect_refusal("coefficients haar", "its Sobolev exponent is 0.5000, but it must exceed 1.0");
  expect_refusal("coefficients D4", "its Sobolev exponent is 1.000, but it must exceed 1.0");
  expect_refusal("coefficients db4 --derivatives 2,2", "but it must exceed 2.0");
  expect_refusal("coefficients db4 --derivatives 1", "two whole numbers");
  expect_refusal("coefficients db4 --derivatives 1,x", "two whole numbers");
  expect_refusal("coefficients db4 --derivatives 9,0", "must be from 0 to 8");
  expect_refusal("coefficients db4 --derivatives 0,1 --normalize first", "index 0 is zero");
  expect_refusal("coefficients db4 --normalize second", "--normalize");
}

}  // namespace
}  // namespace wavecurve::tools
