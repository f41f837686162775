#include "verification/study/join_studies.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace wavecurve::verification {
namespace {

const StudyPlan& plan() {
  static const StudyPlan plan{{{}}, {"decoupled", "implicit-ldlt"}};
  return plan;
}

NamedSource source_of(const std::string& name, std::vector<StudyPoint> points) {
  return {name, [points](const auto& take) {
            for (const StudyPoint& point : points) take(point);
          }};
}

TEST(JoinStudies, PutsShardsTogetherInThePlansOrder) {
  const auto whole = run_study(plan());
  const JoinedStudy joined = join_studies(plan(), {source_of("b", run_study(plan(), {}, {2, 3})),
                                                   source_of("a", run_study(plan(), {}, {1, 3}))});
  EXPECT_EQ(joined.missing, 2u);
  ASSERT_EQ(joined.points.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const StudyPoint& same = whole[i / 2 * 3 + i % 2];
    EXPECT_EQ(joined.points[i].tolerance, same.tolerance);
    EXPECT_EQ(joined.points[i].errors, same.errors);
  }
}

TEST(JoinStudies, TakesTheSamePointOnceAndRefusesTwoResults) {
  const auto points = run_study(plan());
  auto slower = points;
  for (StudyPoint& point : slower) point.seconds *= 2;
  const JoinedStudy joined = join_studies(plan(), {source_of("a", points), source_of("b", slower)});
  EXPECT_EQ(joined.missing, 0u);
  ASSERT_EQ(joined.points.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(joined.points[i].seconds, points[i].seconds);
  }
  const auto refusal = [&](auto change) -> std::string {
    auto other = points;
    change(other[3]);
    try {
      join_studies(plan(), {source_of("a", points), source_of("b", other)});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal([](StudyPoint& p) {
              p.errors->displacement_l2_max = 7;
            }).find("a and b disagree about implicit-ldlt at 0.00390625 (filter db4"),
            std::string::npos);
  for (const auto& message :
       {refusal([](StudyPoint& p) { ++p.fingerprint; }),
        refusal([](StudyPoint& p) { ++p.cost.evaluations; }),
        refusal([](StudyPoint& p) { p.errors.reset(), p.failure = "it stopped"; })}) {
    EXPECT_NE(message.find("disagree"), std::string::npos) << message;
  }
}

TEST(JoinStudies, OfOneSourceTheLastCounts) {
  const auto points = run_study(plan());
  StudyPoint old = points[2];
  old.errors->displacement_l2_max = 7;
  const JoinedStudy joined =
      join_studies(plan(), {source_of("a", points), source_of("b", {old, points[2]})});
  EXPECT_EQ(joined.points[2].errors, points[2].errors);
  EXPECT_THROW(join_studies(plan(), {source_of("a", points), source_of("b", {points[2], old})}),
               std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
