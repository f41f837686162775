#include "tools/commands/output/matrix_file.hpp"

#include <filesystem>
#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/matrix_market.hpp"

namespace wavecurve::tools {

void check_matrix_ending(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  if (!output.empty() && ending != ".mtx" && ending != ".svg") {
    throw std::invalid_argument(
        must_be("output", output, "a file ending in .mtx (MatrixMarket) or .svg (picture)"));
  }
}

void write_matrix(const std::string& output, const Eigen::SparseMatrix<double>& matrix,
                  const std::vector<Eigen::Index>& borders, const io::MatrixPictureText& text) {
  if (output.ends_with(".mtx")) io::write_matrix_market(output, matrix);
  if (output.ends_with(".svg")) {
    io::write_file(output, io::matrix_picture(matrix, borders, text));
  }
}

}  // namespace wavecurve::tools
