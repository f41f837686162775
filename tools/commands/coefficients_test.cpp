#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

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

TEST_F(CoefficientsCommand, IntegralsHaveUpToFourFactors) {
  const json two =
      json::parse(wavecurve("coefficients db3 --integral \"phi' phi(l)\" --format json").out);
  EXPECT_EQ(two["integral"], "phi' phi(l)");
  EXPECT_TRUE(two["on"].is_null());
  EXPECT_EQ(two["entries"].size(), 9U);
  EXPECT_EQ(two["entries"][4]["indices"], json({0}));
  EXPECT_EQ(two["entries"][4]["exact"], "0");
  EXPECT_EQ(two["entries"][5]["exact"], "-272/365");
  // 1/20 = int_0^1 x^4 (1 - x) dx of four hats
  const json four = json::parse(
      wavecurve(
          "coefficients bspline2.2 --integral \"phi phi(l) phi(m) phi(n)\" --digits 20 --format json")
          .out);
  ASSERT_EQ(four["entries"].size(), 15U);
  EXPECT_EQ(four["entries"][8]["indices"], json({0, 0, 1}));
  EXPECT_EQ(four["entries"][8]["value"], "0.050000000000000000000");
}

TEST_F(CoefficientsCommand, IntegralsAreTakenOverIntervals) {
  const json moments = json::parse(
      wavecurve(
          "coefficients bspline2.2 --integral \"x phi(l)\" --on 0,1/2 --digits 10 --format json")
          .out);
  EXPECT_EQ(moments["on"], "0,1/2");
  ASSERT_EQ(moments["entries"].size(), 2U);  // (1 - x) and x on [0, 1/2]
  EXPECT_EQ(moments["entries"][0]["value"], "0.08333333333");
  EXPECT_EQ(moments["entries"][1]["value"], "0.04166666667");
  const std::string csv =
      wavecurve("coefficients db3 --integral \"phi(k) phi'(l)\" --on 0,1 --digits 5 --format csv")
          .out;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 26) << csv;
  EXPECT_NE(csv.find("\"int(phi(l), phi'(m)) on 0,1\",\"(-4, -4)\",-8.9648e-6"), std::string::npos)
      << csv;
}

TEST_F(CoefficientsCommand, PeriodicIntegralsAreCirculant) {
  const json entries = json::parse(
      wavecurve("coefficients db3 --integral \"phi phi\" --period 3 --digits 10 --format json")
          .out)["entries"];
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0]["value"], "1.000000000");
  EXPECT_EQ(entries[1]["value"], "0");
}

TEST_F(CoefficientsCommand, OperatorsHaveCoefficientsUpToAnyIndex) {
  const json half = json::parse(
      wavecurve("coefficients db3 --operator fractional:1/2 --up-to 30 --digits 8 --format json")
          .out);
  EXPECT_EQ(half["operator"], "fractional:1/2");
  ASSERT_EQ(half["entries"].size(), 61U);
  EXPECT_EQ(half["entries"][30]["indices"], json({0}));
  EXPECT_EQ(half["entries"][30]["value"], "0.86541702");
  EXPECT_EQ(half["entries"][0]["exact"], "0");
  const std::string first =
      wavecurve("coefficients db3 --operator derivative:1 --digits 8 --format csv").out;
  EXPECT_NE(first.find("272/365"), std::string::npos);
  const std::string whole =
      wavecurve("coefficients db3 --operator fractional:1 --digits 8 --format csv").out;
  EXPECT_NE(whole.find("272/365"), std::string::npos);
  const std::string hilbert =
      wavecurve("coefficients db6 --operator hilbert --up-to 1 --digits 9").out;
  EXPECT_NE(hilbert.find("0.588303698"), std::string::npos) << hilbert;
}

TEST_F(CoefficientsCommand, OperatorsActOnPeriodicFunctions) {
  const auto values = [&](const std::string& arguments) {
    const json document =
        json::parse(wavecurve("coefficients db3 --digits 8 --format json " + arguments).out);
    std::vector<double> numbers;
    for (const json& entry : document["entries"]) {
      numbers.push_back(std::stod(entry["value"].get<std::string>()));
    }
    return numbers;
  };
  const auto hilbert = values("--operator hilbert --period 4");
  ASSERT_EQ(hilbert.size(), 4U);
  EXPECT_EQ(hilbert[0], 0);
  EXPECT_EQ(hilbert[2], 0);
  EXPECT_EQ(hilbert[1], -hilbert[3]);
  // The frequency 1 of 4 is multiplied by -i |F|^2-sums near 1: r_1 - r_3 is near 1.
  EXPECT_NEAR(hilbert[1] - hilbert[3], 1, 0.1);
  EXPECT_EQ(values("--operator derivative:1 --period 5"),
            values("--integral \"phi' phi(l)\" --period 5"));
}

TEST_F(CoefficientsCommand, IntegralsFromZeroToEveryX) {
  const json document = json::parse(
      wavecurve("coefficients db3 --integral \"phi'(l) phi\" --on 0,x --level 1 --digits 15 "
                "--format json")
          .out);
  EXPECT_EQ(document["on"], "0,x");
  const json one = json::parse(
      wavecurve("coefficients db3 --integral \"phi'(l) phi\" --on 0,3/2 --digits 15 --format json")
          .out);
  std::size_t found = 0;
  for (const auto& entry : document["entries"]) {
    for (const auto& alone : one["entries"]) {
      if (entry["indices"] != json::array({"3/2", alone["indices"][0]})) continue;
      EXPECT_EQ(entry["value"], alone["value"]);
      ++found;
    }
  }
  EXPECT_GT(found, 0U);
  EXPECT_EQ(found, std::ranges::count_if(one["entries"],
                                         [](const json& entry) { return entry["value"] != "0"; }));
}

TEST_F(CoefficientsCommand, SplinesHaveFractionsOfAnyNumberOfFactors) {
  const json document = json::parse(
      wavecurve("coefficients bspline2.2 --integral \"phi phi(l) phi(m)\" --format json").out);
  for (const auto& entry : document["entries"]) {
    EXPECT_TRUE(entry["exact"] == "1/2" || entry["exact"] == "1/12") << entry;
  }
}

TEST_F(CoefficientsCommand, MomentsComeWithReproductionAndQuadrature) {
  const json document =
      json::parse(wavecurve("coefficients cdf9.7 --moments 3 --digits 12 --format json").out);
  EXPECT_EQ(document["moments"], 3);
  std::map<std::string, int> counts;
  for (const auto& entry : document["entries"]) ++counts[entry["quantity"].get<std::string>()];
  EXPECT_EQ(counts, (std::map<std::string, int>{{"moment(phi)", 4},
                                                {"moment(psi)", 4},
                                                {"moment(phi~)", 4},
                                                {"moment(psi~)", 4},
                                                {"reproduction(phi)", 4},
                                                {"weight(phi)", 4}}));
  io::write_file(folder_ / "m.hpp", wavecurve("coefficients cdf9.7 --moments 3 --format cpp").out);
  io::write_file(
      folder_ / "m.cpp",
      "#include \"m.hpp\"\nstatic_assert(wavecurve_tables::cdf9_7::moment_phi_dual[0] == 1);\n");
  EXPECT_EQ(run("c++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only '" +
                (folder_ / "m.cpp").string() + "'")
                .exit_code,
            0);
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
  expect_refusal("coefficients db4 --integral \"phi ph(l)\"", "at column 5");
  expect_refusal("coefficients db4 --integral \"\"", "at column 1");
  expect_refusal("coefficients db4 --integral \"phi phi phi phi phi\"", "at most 4 factors");
  expect_refusal("coefficients db2 --integral \"phi' phi' phi\"", "but it must exceed 1.0");
  expect_refusal("coefficients db4 --integral \"phi phi\" --on 1,0", "from 1 to 0 is reversed");
  expect_refusal("coefficients db4 --integral \"phi phi\" --on 0,1/3", "multiples of 1/1024");
  expect_refusal("coefficients db4 --integral \"phi phi\" --on \"\"", "the interval is ''");
  expect_refusal("coefficients db38 --integral \"phi phi' phi''\"", "number of unknown integrals");
  expect_refusal("coefficients db4 --on 0,1", "--on requires --integral");
  expect_refusal("coefficients db4 --integral \"x phi phi\" --period 4",
                 "periodic factors take neither");
  expect_refusal("coefficients db4 --integral \"phi phi phi phi\" --period 4000",
                 "number of integrals");
  expect_refusal("coefficients db4 --integral \"phi(l) phi(m)\" --on 0,x",
                 "a factor without a letter");
  expect_refusal("coefficients db4 --integral \"x phi(l) phi\" --on 0,x",
                 "one of phi and psi at x or x - l");
  expect_refusal("coefficients db4 --operator laplace", "hilbert, hilbert:S, riesz:S");
  expect_refusal("coefficients db4 --operator hilbert --period 20000", "from 1 to 16384");
  expect_refusal("coefficients db4 --operator hilbert --period 8 --up-to 3", "--period");
  expect_refusal("coefficients db4 --period 8", "--period takes --integral or --operator");
  expect_refusal("coefficients db4 --operator fractional:x", "hilbert, hilbert:S, riesz:S");
  expect_refusal("coefficients db4 --operator derivative:9", "from 0 to 8");
  expect_refusal("coefficients db2 --operator fractional:2.5", "but it must exceed 1.25");
  expect_refusal("coefficients db4 --level 3", "--level takes --quantity or --on 0,x");
}

}  // namespace
}  // namespace wavecurve::tools
