#include "verification/quantities/quantity.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "verification/quantities/quantity_families.hpp"

namespace wavecurve::verification {
namespace {

TEST(Quantity, EveryNameIsReadBackAsItIsWritten) {
  for (const char* name : {"h",
                           "g",
                           "dual(h)",
                           "dual(g)",
                           "h*sqrt2",
                           "h/sqrt2",
                           "g*2",
                           "alpha",
                           "mu",
                           "nu",
                           "mu/mu0",
                           "nu/nu0",
                           "-mu",
                           "r",
                           "int(phi'', phi)",
                           "int(phi'', phi)/first",
                           "int(psi', phi)",
                           "int(phi, phi(l), phi'(m))",
                           "int(phi, phi, phi')",
                           "int(phi(l), phi'')",
                           "int(phi, phi, phi, phi')",
                           "int(phi(l), phi, phi(m), psi(n))",
                           "int(phi(l), phi'(m)) on [0,1]",
                           "int(phi, phi', psi) on [-1/2,3/4]*2",
                           "int(phi'(l), phi) on [0,x]/first",
                           "phi",
                           "psi''",
                           "phi~",
                           "phi^(4)",
                           "moment(psi)",
                           "sobolev(phi~)",
                           "holder(phi)",
                           "lifting",
                           "h*2*sqrt2"}) {
    const Quantity quantity = parse_quantity(name);
    EXPECT_EQ(parse_quantity(to_string(quantity)), quantity) << name;
  }
  EXPECT_EQ(to_string(parse_quantity("int(phi',phi')")), "mu");
  EXPECT_EQ(to_string(parse_quantity("int(phi(l) phi')")), "r");
  EXPECT_EQ(to_string(parse_quantity("mu/first")), "mu/mu0");
  EXPECT_EQ(to_string(parse_quantity("int(φ″, φ)")), "int(phi'', phi)");
  EXPECT_EQ(to_string(parse_quantity("int(phi'(a) phi phi(b))")), "int(phi'(l), phi, phi(m))");
  EXPECT_EQ(to_string(parse_quantity("dual(phi')")), "phi~'");
  EXPECT_EQ(to_string(parse_quantity("int(phi^(2), phi)")), "int(phi'', phi)");
  EXPECT_EQ(to_string(parse_quantity("int(phi phi(l)) on [0, 0.5]")), "int(phi, phi) on [0,1/2]");
}

TEST(Quantity, NamesOfThePublicationAreThoseOfTheGrammar) {
  EXPECT_EQ(parse_quantity("h"), Quantity::taps);
  EXPECT_EQ(parse_quantity("h*sqrt2"), Quantity::taps_sum_2);
  EXPECT_EQ(parse_quantity("mu/mu0"), Quantity::mu_normalized);
  EXPECT_EQ(parse_quantity("int(psi', psi')"), Quantity::nu);
  EXPECT_TRUE(is_taps(Quantity::taps_sum_1));
  EXPECT_FALSE(is_taps(parse_quantity("g")));
}

TEST(Quantity, AMessageMarksTheColumn) {
  for (const auto& [text, column] : {std::pair{"int(phi'', ph)", 12},
                                     {"foo", 1},
                                     {"h*3", 2},
                                     {"int(phi)", 9},
                                     {"int(phi, phi, phi, phi, phi)", 25},
                                     {"int(phi, phi, phi, phi) on [0,1]", 33},
                                     {"int(phi(l), phi(m)) on [0,x]", 29},
                                     {"int(phi, phi) on 0,1", 18},
                                     {"int(phi, phi) on [0,1", 19},
                                     {"phi'''''''''", 13},
                                     {"int(phi(l), phi(l))", 17},
                                     {"moment(h)", 8},
                                     {"", 1},
                                     {"phi^(12)", 6},
                                     {"mu mu", 4},
                                     {"int(phi(l), phi(m))", 20}}) {
    try {
      parse_quantity(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("column " + std::to_string(column) + ":"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(Quantity, AnIndexHasOneNumberForEachLetterAndForX) {
  EXPECT_EQ(parse_quantity("mu").index_count(), 1);
  EXPECT_EQ(parse_quantity("moment(phi)").index_count(), 1);
  EXPECT_EQ(parse_quantity("int(phi, phi, phi, phi)").index_count(), 3);
  EXPECT_EQ(parse_quantity("int(phi(l), phi(m)) on [0,1]").index_count(), 2);
  EXPECT_EQ(parse_quantity("int(phi'(l), phi) on [0,x]").index_count(), 2);
  EXPECT_THROW(parse_quantity("int(phi, phi) on [1,0]"), std::invalid_argument);
}

TEST(Quantity, EveryFamilyHasAnExampleThatIsUnderstood) {
  for (const QuantityFamily& family : quantity_families()) {
    const Quantity quantity = parse_quantity(family.example);
    EXPECT_EQ(quantity.family->name, family.name);
    EXPECT_EQ(parse_quantity(to_string(quantity)), quantity) << family.name;
    EXPECT_NE(quantities_help().find(family.example), std::string::npos);
  }
}

}  // namespace
}  // namespace wavecurve::verification
