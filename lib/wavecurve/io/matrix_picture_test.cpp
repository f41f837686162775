#include "wavecurve/io/matrix_picture.hpp"

#include <cmath>
#include <regex>
#include <string>

#include <gtest/gtest.h>

namespace wavecurve::io {
namespace {

Eigen::SparseMatrix<double> diagonal(int size) {
  Eigen::SparseMatrix<double> matrix(size, size);
  for (int i = 0; i < size; ++i) matrix.insert(i, i) = std::pow(10.0, i % 4);
  matrix.makeCompressed();
  return matrix;
}

const MatrixPictureText text{"a < b & c", "what it shows", "magnitude"};

/// The cells drawn, and the colours in order from the smallest magnitude.
int cells_drawn(const std::string& svg) {
  // By hand, for std::regex recurses, and the path data are long.
  int count = 0;
  for (std::size_t i = svg.find('M'); i != std::string::npos; i = svg.find('M', i + 1)) {
    const std::size_t end = svg.find_first_not_of("0123456789 ", i + 1);
    count += end != std::string::npos && end > i + 1 && svg[end] == 'h';
  }
  return count;
}

TEST(MatrixPicture, DrawsEveryNonZeroAndEscapesTheText) {
  const std::string svg = matrix_picture(diagonal(16), {8}, text);
  EXPECT_EQ(cells_drawn(svg), 16);
  EXPECT_NE(svg.find("<title id=\"title\">a &lt; b &amp; c</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc id=\"desc\">what it shows</desc>"), std::string::npos);
  EXPECT_NE(svg.find("M256.00 0V512.00"), std::string::npos);  // the border halves the picture
  EXPECT_NE(svg.find(">1e3<"), std::string::npos);
}

TEST(MatrixPicture, GathersLargeMatricesIntoAtMost256Cells) {
  EXPECT_EQ(cells_drawn(matrix_picture(diagonal(1024), {}, text)), 256);
}

TEST(MatrixPicture, ColoursDarkenFromTheBottomOfTheBarUpwards) {
  const std::string svg = matrix_picture(diagonal(4), {}, text);
  const std::regex shade(
      "<rect y=\"[0-9.]+\" width=\"18\" height=\"[0-9.]+\" fill=\"#(..)(..)(..)\"");
  double last = 256;
  int count = 0;
  for (auto match = std::sregex_iterator(svg.begin(), svg.end(), shade);
       match != std::sregex_iterator(); ++match, ++count) {
    const auto channel = [&](int i) {
      return std::stoi((*match)[static_cast<std::size_t>(i)], nullptr, 16);
    };
    const double luma = 0.299 * channel(1) + 0.587 * channel(2) + 0.114 * channel(3);
    EXPECT_LT(luma, last);
    last = luma;
  }
  EXPECT_EQ(count, 48);
}

TEST(MatrixPicture, TakesAnEmptyAndAZeroMatrix) {
  EXPECT_EQ(cells_drawn(matrix_picture(Eigen::SparseMatrix<double>(4, 4), {}, text)), 0);
  EXPECT_EQ(cells_drawn(matrix_picture(Eigen::SparseMatrix<double>(0, 0), {}, text)), 0);
}

}  // namespace
}  // namespace wavecurve::io
