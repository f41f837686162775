#include "wavecurve/io/matrix_market.hpp"

#include <filesystem>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

#include "wavecurve/io/files/read_file.hpp"

namespace wavecurve::io {
namespace {

class MatrixMarket : public testing::Test {
 protected:
  MatrixMarket() { std::filesystem::create_directories(directory_); }
  ~MatrixMarket() override { std::filesystem::remove_all(directory_); }

  std::filesystem::path directory_ =
      std::filesystem::temp_directory_path() /
      ("wavecurve-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

Eigen::SparseMatrix<double> matrix_of(double corner) {
  Eigen::Matrix3d dense;
  dense << 1.0 / 3, 0, -1e-300, 0, 0, 2.5e17, corner, 2.5e17, 4;
  return dense.sparseView();
}

TEST_F(MatrixMarket, RoundTripsExactlyAndStoresHalfOfASymmetricMatrix) {
  for (double corner : {-1e-300, 7.0}) {
    const auto matrix = matrix_of(corner);
    const auto path = directory_ / "m.mtx";
    write_matrix_market(path, matrix);
    EXPECT_EQ(read_matrix_market(path).toDense(), matrix.toDense());
    const bool symmetric = corner != 7;
    const std::string text = read_file(path);
    EXPECT_EQ(text.find("symmetric") != std::string::npos, symmetric);
    EXPECT_NE(text.find(symmetric ? "3 3 4\n" : "3 3 6\n"), std::string::npos);
  }
}

TEST_F(MatrixMarket, SaysWhichFileItCouldNotWriteOrRead) {
  const auto nowhere = directory_ / "none" / "m.mtx";
  EXPECT_THROW(write_matrix_market(nowhere, matrix_of(0)), std::system_error);
  EXPECT_THROW(read_matrix_market(nowhere), std::system_error);
  EXPECT_THROW(write_matrix_market("/dev/full", matrix_of(0)), std::system_error);
}

}  // namespace
}  // namespace wavecurve::io
