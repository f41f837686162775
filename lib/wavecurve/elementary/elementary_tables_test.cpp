#include "wavecurve/elementary/detail/elementary_tables.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "wavecurve/certified/detail/elementary/elementary_table_source.hpp"

namespace wavecurve {
namespace {

TEST(ElementaryTables, AreWhatTheirGeneratorWrites) {
  const std::string path =
      WAVECURVE_SOURCE_DIR "/lib/wavecurve/elementary/detail/elementary_tables.hpp";
  std::ostringstream committed;
  committed << std::ifstream(path).rdbuf();
  EXPECT_TRUE(certified::elementary_table_source() == committed.str())
      << "run generate_elementary_tables " << path;
}

TEST(ElementaryTables, ProveOneUnit) {
  EXPECT_LE(elementary::sine_bound, 1);
  EXPECT_LE(elementary::cosine_bound, 1);
  EXPECT_LE(elementary::exponential_bound, 1);
  EXPECT_LE(elementary::logarithm_bound, 1);
  EXPECT_LE(elementary::arctangent_bound, 1);
}

}  // namespace
}  // namespace wavecurve
