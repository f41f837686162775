#include "benchmarks/pages/limit_reasons.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::tracking {
namespace {

class LimitReasonsTest : public testing::Test {
 protected:
  LimitReasonsTest() { std::filesystem::create_directories(history_ / "reasons"); }
  ~LimitReasonsTest() override { std::filesystem::remove_all(history_); }

  void write(const std::string& name, const std::string& text) {
    io::write_file(history_ / "reasons" / name, text);
  }

  const std::filesystem::path history_ =
      std::filesystem::temp_directory_path() /
      (std::string("wavecurve_reasons_") +
       testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(LimitReasonsTest, AreThoseOfTheLatestFile) {
  EXPECT_TRUE(read_limit_reasons(history_).of_kernel.empty());
  write("2026-01-02T00-00-00Z-b.json", R"({"commit": "b", "kernels": {"k": "branches"}})");
  write("2026-01-01T00-00-00Z-a.json", R"({"commit": "a", "kernels": {"k": "shuffles"}})");
  write("notes.txt", "no reasons");
  EXPECT_EQ(read_limit_reasons(history_).text("k", "b"), "branches");
  EXPECT_EQ(read_limit_reasons(history_).text("unknown", "b"), "");
  EXPECT_TRUE(read_limit_reasons(history_ / "missing").of_kernel.empty());
}

TEST_F(LimitReasonsTest, SayWhenAnotherRevisionWasMeasured) {
  const LimitReasons reasons{"0123456789abcdef", {{"k", "branches"}}};
  EXPECT_EQ(reasons.text("k", "fedcba"),
            "(Measured at revision 0123456789, not at this record's.) branches");
}

TEST_F(LimitReasonsTest, RefuseAFileOfAnotherForm) {
  write("x.json", R"({"commit": 5})");
  EXPECT_THROW(read_limit_reasons(history_), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::tracking
