#include "benchmarks/tracking/timing.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

#include "benchmarks/tracking/compare.hpp"

namespace wavecurve::tracking {
namespace {

namespace fs = std::filesystem;

/// A benchmark program that is a script: quick/1 takes the nanoseconds that stand in the file
/// `quick` beside it, more by 1 % every second time it runs; steady/1 always 100.
constexpr const char* script = R"(#!/bin/sh
here=${0%/*}
case $1 in --benchmark_list_tests*) printf 'a table\nquick/1\nsteady/1\n'; exit 0 ;; esac
for argument; do
  case $argument in
    --benchmark_out=*) out=${argument#*=} ;;
    --benchmark_filter=*) name=${argument#*=} ;;
  esac
done
case $name in
  '^quick/1$') name=quick/1; time=$(cat "$here/quick") ;;
  '^steady/1$') name=steady/1; time=100 ;;
  *) echo '{"benchmarks": []}' >"$out"; exit 0 ;;
esac
echo run >>"$here/runs"
if [ $(($(wc -l <"$here/runs") % 2)) -eq 0 ]; then time=$time.5; fi
cat >"$out" <<END
{"benchmarks": [{"name": "$name", "run_type": "iteration", "iterations": 7, "real_time": 1,
                 "cpu_time": $time, "time_unit": "ns", "error": 0.25},
                {"name": "${name}_cv", "run_type": "aggregate", "error": NaN, "rate": -inf}]}
END
)";

class TimingTest : public testing::Test {
 protected:
  void SetUp() override {
    write(a(), "100");
    write(b(), "130");
  }
  void TearDown() override { fs::remove_all(folder_); }

  static void write(const fs::path& folder, const std::string& quick) {
    fs::create_directories(folder);
    io::write_file(folder / "fake_benchmark", script + ("# " + quick));
    fs::permissions(folder / "fake_benchmark", fs::perms::owner_all);
    io::write_file(folder / "quick", quick);
  }
  fs::path a() const { return folder_ / "a"; }
  fs::path b() const { return folder_ / "b"; }
  static void silent(const std::string&) {}

  const fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve timing " + std::to_string(::getpid()));
};

TEST_F(TimingTest, ListsNamesAndNothingElse) {
  const auto names = list_benchmarks(a() / "fake_benchmark");
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[0].name, "quick/1");
  EXPECT_EQ(list_benchmarks(a() / "fake_benchmark", "^steady").size(), 1u);
}

TEST_F(TimingTest, ReadsTimes) {
  EXPECT_DOUBLE_EQ(time_once(a() / "fake_benchmark", "quick/1", 0.1), 100e-9);
  EXPECT_EQ(run_benchmark(a() / "fake_benchmark", "steady/1", 0.1)[0]["error"], 0.25);
  try {
    time_once(a() / "fake_benchmark", "quick/11", 0.1);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "fake_benchmark has no benchmark quick/11");  // and no folder
  }
  EXPECT_EQ(seconds_of_unit("us"), 1e-6);
}

TEST_F(TimingTest, ComparesBuilds) {
  CompareOptions options;
  options.filter = ".";
  const Comparison c = compare({"a", build_in(a()), {}}, {"b", build_in(b()), {}}, options, silent);
  ASSERT_EQ(c.rows.size(), 2u);
  EXPECT_EQ(c.verdict_of("quick/1"), Change::slower);
  EXPECT_NEAR(c.rows[0].ratio.ratio, 1.3, 0.01);
  EXPECT_NE(c.rows[0].note.find("confirmed by a second"), std::string::npos);
  EXPECT_EQ(c.verdict_of("steady/1"), Change::same);
  EXPECT_EQ(c.exit_code(), 1);
}

TEST_F(TimingTest, SkipsIdenticalPrograms) {
  CompareOptions options;
  options.filter = ".";
  const Comparison c = compare({"a", build_in(a()), {}}, {"b", build_in(a()), {}}, options, silent);
  EXPECT_TRUE(c.rows.empty());
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("byte for byte"), std::string::npos);
  EXPECT_FALSE(fs::exists(a() / "runs"));
}

TEST_F(TimingTest, EveryBlockHasBothOrdersInTurn) {
  std::string order;
  const TimedPair pair{"pair", [&] { return order += 'a', 1.0; },
                       [&] { return order += 'b', 2.0; }};
  const auto times = time_interleaved({pair}, 20, 3, silent);
  ASSERT_EQ(times[0].size(), 20u);
  bool has_abba = false, has_baab = false;
  for (std::size_t i = 0; i < order.size(); i += 4) {
    has_abba |= order.substr(i, 4) == "abba";
    has_baab |= order.substr(i, 4) == "baab";
    EXPECT_TRUE(order.substr(i, 4) == "abba" || order.substr(i, 4) == "baab");
  }
  EXPECT_TRUE(has_abba && has_baab);
  EXPECT_DOUBLE_EQ(bootstrap_ratio(times[0]).ratio, 2);
}

}  // namespace
}  // namespace wavecurve::tracking
