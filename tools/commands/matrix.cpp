#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/basis_function.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/operators/differentiation.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/nonstandard_form.hpp"
#include "wavecurve/transform/bands.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/matrix_file.hpp"

namespace wavecurve::tools {

namespace {

struct MatrixOptions {
  std::string name, form = "galerkin", output;
  int derivative = 1;
  long samples = 64;
  int levels = -1;  ///< -1: all
};

/// A matrix, and where its blocks begin.
struct DrawnMatrix {
  Eigen::SparseMatrix<double> matrix;
  std::vector<Eigen::Index> borders;
  int levels = 0;
};

std::string operator_name(int derivative) {
  if (derivative == 0) return "identity";
  return derivative == 1 ? "d/dx" : fmt::format("d^{0}/dx^{0}", derivative);
}

bool is_multiscale(const std::string& form) { return form == "standard" || form == "nonstandard"; }

/// What a circulant makes of sin(2 pi x): its error at the samples, as a share of the derivative.
double error_on_sine(const Eigen::SparseMatrix<double>& matrix, int derivative) {
  const Eigen::Index n = matrix.rows();
  const double step = 2 * std::numbers::pi / static_cast<double>(n);
  const double size = std::pow(2 * std::numbers::pi, derivative);
  Eigen::VectorXd sine(n), expected(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = step * static_cast<double>(i);
    sine[i] = std::sin(x);
    expected[i] = size * std::sin(x + 0.5 * std::numbers::pi * derivative);
  }
  return (matrix * sine - expected).cwiseAbs().maxCoeff() / size;
}

std::vector<Eigen::Index> nonstandard_borders(Eigen::Index samples, int levels) {
  std::vector<Eigen::Index> borders;
  Eigen::Index corner = 0;
  for (int level = levels; level >= 1; --level) {
    const Eigen::Index n = samples >> level;
    borders.insert(borders.end(), {corner + n, corner + 2 * n});
    corner += 2 * n;
  }
  borders.pop_back();
  return borders;
}

/// The entries are bounded before they are asked for: a row has at most all columns, and at most as
/// many as the supports of two functions meet on each pair of levels.
void check_entries(const FilterBank<double>& bank, const MatrixOptions& options, int levels) {
  constexpr double most = 4e7;
  const auto samples = static_cast<double>(options.samples);
  const double taps = bank.synthesis_low.size() + bank.analysis_low.size();
  const double a_row =
      options.form == "collocation" ? samples : std::min(samples, (levels + 1.0) * 2 * taps);
  if (samples * a_row <= most) return;
  throw std::invalid_argument(fmt::format(
      "the {} form of {} samples has up to {:.3g} entries, but must have at most {:.3g}",
      options.form, options.samples, samples * a_row, most));
}

DrawnMatrix make_matrix(const FilterBank<double>& bank, const MatrixOptions& options) {
  const auto& [name, form, output, derivative, samples, asked_levels] = options;
  if (!is_multiscale(form)) {
    check_entries(bank, options, 0);
    return {circulant_matrix(form == "galerkin"
                                 ? galerkin_differentiation(bank, samples, derivative)
                                 : collocation_differentiation(bank, samples, derivative)),
            {}};
  }
  if (samples < 2) {
    throw std::invalid_argument(must_be("samples", samples, "a power of two from 2 on"));
  }
  const int most = checked_log2(samples);
  const int levels = asked_levels < 0 ? most : asked_levels;
  check_entries(bank, options, levels);
  if (form == "standard") {
    return {multiscale_matrix(bank, samples, levels, 0, derivative), band_borders(samples, levels),
            levels};
  }
  return {nonstandard_matrix(nonstandard_form(bank, derivative), samples, levels),
          nonstandard_borders(samples, levels), levels};
}

void print_matrix(const FilterBank<double>& bank, const MatrixOptions& options,
                  const DrawnMatrix& drawn) {
  const Eigen::SparseMatrix<double>& matrix = drawn.matrix;
  const double entries = static_cast<double>(matrix.rows()) * static_cast<double>(matrix.cols());
  fmt::print("{} of {}, {} form, unit interval, periodic\n", operator_name(options.derivative),
             printable(bank.name), options.form);
  fmt::print("samples          {}\n", options.samples);
  if (is_multiscale(options.form)) fmt::print("levels           {}\n", drawn.levels);
  fmt::print("size             {} x {}\n", matrix.rows(), matrix.cols());
  fmt::print("non-zeros        {} ({:.3g} % of the entries)\n", matrix.nonZeros(),
             100 * static_cast<double>(matrix.nonZeros()) / entries);
  fmt::print("largest entry    {:.8g}\n", matrix.coeffs().cwiseAbs().maxCoeff());
  if (!is_multiscale(options.form)) {
    fmt::print("error on sin(2 pi x)  {:.3g} of the derivative's amplitude\n",
               error_on_sine(matrix, options.derivative));
  }
}

void run_matrix(const MatrixOptions& options) {
  check_matrix_ending(options.output);
  if (options.levels >= 0 && !is_multiscale(options.form)) {
    throw std::invalid_argument("--levels takes --form standard or --form nonstandard");
  }
  const FilterBank<double> bank = io::load_filter_bank(options.name);
  const DrawnMatrix drawn = make_matrix(bank, options);
  write_matrix(
      options.output, drawn.matrix, drawn.borders,
      {fmt::format("{} of {}, {} form, {} samples", operator_name(options.derivative), bank.name,
                   options.form, options.samples),
       fmt::format("Magnitudes of the entries; {} of them are not zero.", drawn.matrix.nonZeros()),
       "magnitude of the entry (unit interval)"});
  print_matrix(bank, options, drawn);
}

}  // namespace

void add_matrix_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<MatrixOptions>();
  CLI::App* command = app.add_subcommand(
      "matrix", "Print properties of a periodic derivative's matrix, or write it or its picture");
  command->add_option("NAME", options->name, "Filter name, or path to a JSON filter file")
      ->required();
  command
      ->add_option("--form", options->form,
                   "galerkin: coefficients to the coefficients of the derivative's projection\n"
                   "collocation: samples to the derivative's samples\n"
                   "standard: int b_i (d^D b_j / dx^D) dx of the multiscale basis, all blocks\n"
                   "nonstandard: blocks of one level each (Beylkin, Coifman and Rokhlin)")
      ->check(CLI::IsMember({"galerkin", "collocation", "standard", "nonstandard"}))
      ->capture_default_str();
  command->add_option("--derivative", options->derivative, "Order D of the derivative")
      ->check(whole_number_from(0, highest_derivative))
      ->capture_default_str();
  command
      ->add_option("--samples", options->samples,
                   "Number of samples; a power of two for the multiscale forms")
      ->check(samples_check())
      ->capture_default_str();
  command
      ->add_option("--levels", options->levels,
                   "Levels of decomposition of a multiscale form; all by default")
      ->check(levels_check());
  command->add_option("-o,--output", options->output,
                      "Write the matrix (.mtx, MatrixMarket) or its picture (.svg)");
  command->callback([options] { run_matrix(*options); });
}

}  // namespace wavecurve::tools
