#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/operators/matrix_measures.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/spectrum.hpp"
#include "wavecurve/transform/bands.hpp"

#include "tools/commands/commands.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/matrix_file.hpp"

namespace wavecurve::tools {

namespace {

struct StiffnessOptions {
  std::string name, output;
  long samples = 64;
  int levels = -1;  ///< -1: all
};

void print_measures(const FilterBank<double>& bank, const Eigen::SparseMatrix<double>& k,
                    int levels) {
  const double entries = static_cast<double>(k.rows()) * static_cast<double>(k.cols());
  fmt::print("stiffness K of {}, e_0 = 1, unit parameter interval\n", printable(bank.name));
  fmt::print("samples                       {}\n", k.rows());
  fmt::print("levels                        {}\n", levels);
  fmt::print("non-zeros                     {} ({:.3g} % of the entries)\n", k.nonZeros(),
             100 * static_cast<double>(k.nonZeros()) / entries);
  fmt::print("symmetry error                {:.3g}\n", symmetry_error(k));
  fmt::print("off-diagonal energy           {:.2f} % of the sum of squares\n",
             100 * off_diagonal_energy(k));
}

void print_spectrum(const ExtremeEigenvalues& ends, double first_vibration) {
  fmt::print("smallest non-zero eigenvalue  {:.8g}\n", ends.smallest);
  fmt::print("largest eigenvalue            {:.8g}\n", ends.largest);
  fmt::print("condition number              {:.6g}\n", ends.condition_number());
  fmt::print("first vibration eigenvalue    {:.8g} (of K x = lambda M x; tends to (2 pi)^2)\n",
             first_vibration);
}

io::MatrixPictureText picture_text(const FilterBank<double>& bank,
                                   const Eigen::SparseMatrix<double>& k, int levels) {
  return {
      fmt::format("Stiffness K of {}, {} x {}, levels: {}", bank.name, k.rows(), k.cols(), levels),
      fmt::format("Magnitudes of the entries in global-to-local order; {} of them are not zero.",
                  k.nonZeros()),
      "magnitude of the entry (e_0 = 1, unit interval)"};
}

/// What a matrix holds, and its making takes, goes with its rows, its levels and the taps.
void check_work(const FilterBank<double>& bank, long samples, int levels) {
  constexpr double most = 2e7;
  const auto taps = static_cast<double>(bank.synthesis_low.size() + bank.analysis_low.size());
  const double work = static_cast<double>(samples) * (levels + 1.0) * taps;
  if (work <= most) return;
  throw std::invalid_argument(fmt::format(
      "{} samples, {} levels and the {} taps of {} on both sides make too large a matrix: samples "
      "times one more than levels times taps is {:.3g}, but must be at most {:.3g}",
      samples, levels, taps, bank.name, work, most));
}

void run_stiffness(const StiffnessOptions& options) {
  check_matrix_ending(options.output);
  const FilterBank<double> bank = io::load_filter_bank(options.name);
  if (options.samples < 2) {
    throw std::invalid_argument(must_be("samples", options.samples, "a power of two from 2 on"));
  }
  const int most = checked_log2(options.samples);
  const int levels = options.levels < 0 ? most : options.levels;
  check_work(bank, options.samples, levels);
  const Eigen::SparseMatrix<double> k = stiffness(bank, options.samples, levels);
  const ExtremeEigenvalues ends = extreme_eigenvalues(bank, options.samples, levels, 1);
  const double first_vibration = vibration_eigenvalues(bank, options.samples)[1];
  write_matrix(options.output, k, band_borders(k.rows(), levels), picture_text(bank, k, levels));
  print_measures(bank, k, levels);
  print_spectrum(ends, first_vibration);
}

}  // namespace

void add_stiffness_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<StiffnessOptions>();
  CLI::App* command = app.add_subcommand(
      "stiffness",
      "Print properties of the multiscale stiffness matrix, or write the matrix or its picture");
  command->add_option("NAME", options->name, "Filter name, or path to a JSON filter file")
      ->required();
  command->add_option("--samples", options->samples, "Number of samples, a power of two")
      ->check(samples_check())
      ->capture_default_str();
  command
      ->add_option("--levels", options->levels,
                   "Levels of decomposition, 0 for the single-scale matrix; all by default")
      ->check(levels_check());
  command->add_option("--output", options->output,
                      "Write the matrix (.mtx, MatrixMarket) or its picture (.svg)");
  command->callback([options] { run_stiffness(*options); });
}

}  // namespace wavecurve::tools
