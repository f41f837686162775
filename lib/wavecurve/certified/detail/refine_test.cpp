#include "wavecurve/certified/detail/refine.hpp"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace wavecurve::certified {
namespace {

const std::vector<long> every_attempt{100, 200, 400, 800, 1600, 3200};

TEST(Refine, DoublesThePrecisionUntilThereIsAnAnswer) {
  std::vector<long> tried;
  const auto answer = refine(100, [&](long bits) -> std::optional<long> {
    EXPECT_EQ(WorkingPrecision::bits(), bits);
    tried.push_back(bits);
    if (bits < 400) return std::nullopt;
    return -bits;
  });
  EXPECT_EQ(answer, -400);
  EXPECT_EQ(tried, std::vector<long>({100, 200, 400}));
  EXPECT_EQ(WorkingPrecision::bits(), 128) << "the precision of before";
}

TEST(Refine, ReturnsWhatTheLastAttemptReturned) {
  std::vector<long> tried;
  EXPECT_FALSE(refine(100, [&](long bits) {
    tried.push_back(bits);
    return false;
  }));
  EXPECT_EQ(tried, every_attempt);
}

TEST(Refine, TakesADomainErrorForNoAnswer) {
  EXPECT_EQ(refine(100,
                   [](long bits) {
                     if (bits < 400) throw std::domain_error("too wide");
                     return std::optional(bits);
                   }),
            400);
  std::vector<long> tried;
  EXPECT_THROW(refine(100,
                      [&](long bits) -> bool {
                        tried.push_back(bits);
                        throw std::domain_error("too wide");
                      }),
               std::domain_error);
  EXPECT_EQ(tried, every_attempt);
  EXPECT_EQ(WorkingPrecision::bits(), 128);
}

TEST(Refine, StopsAboveTheBitsThatTheDataHave) {
  const auto tried_with = [](long known_bits) {
    std::vector<long> tried;
    EXPECT_FALSE(refine(
        100,
        [&](long bits) {
          tried.push_back(bits);
          return false;
        },
        known_bits));
    return tried;
  };
  EXPECT_EQ(tried_with(30), std::vector<long>({100}));
  EXPECT_EQ(tried_with(100), std::vector<long>({100, 200}));
  EXPECT_EQ(tried_with(500), std::vector<long>({100, 200, 400, 800}));
  EXPECT_EQ(tried_with(1000000), every_attempt);
}

TEST(Refine, PassesOtherExceptionsAtOnce) {
  int attempts = 0;
  EXPECT_THROW(refine(100,
                      [&](long) -> bool {
                        ++attempts;
                        throw std::invalid_argument("wrong");
                      }),
               std::invalid_argument);
  EXPECT_EQ(attempts, 1);
}

}  // namespace
}  // namespace wavecurve::certified
