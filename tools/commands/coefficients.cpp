#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wavecurve/certified/certified_decimals.hpp"
#include "wavecurve/certified/integrals/homogeneous_operator.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/point_values.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/characters.hpp"
#include "wavecurve/integrals/product_integral.hpp"
#include "wavecurve/io/files/detail/csv.hpp"
#include "wavecurve/io/files/detail/json_text.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "tools/commands/coefficients/operator_output.hpp"
#include "tools/commands/coefficients/quantity_output.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/markup_table.hpp"
#include "tools/commands/output/number_format.hpp"
#include "verification/quantities/integral_expression.hpp"

namespace wavecurve::tools {

namespace {

using certified::DecimalEnclosure;
using certified::FilterDefinition;
using nlohmann::ordered_json;

struct CoefficientsOptions {
  std::string name;
  std::string derivatives = "1,1";
  int digits = 40;
  std::string normalization = "none";
  std::string format = "text";
  std::optional<std::string> quantity, integral, named_operator;
  IntegralRange range;
  std::optional<int> moments;
  int level = 0;
  OperatorRange operator_range;
};

struct Orders {
  int p, q;
};

/// Values for the indices 0, 1, 2, ... of one of the three sequences.
struct Column {
  const char* name;
  std::vector<DecimalEnclosure> values;
};

Orders parse_orders(const std::string& text) {
  Orders orders{};
  const auto comma = text.find(',');
  const auto number = [&](std::string_view part, int& value) {
    const auto parsed = parsed_whole_number(part);
    if (parsed) value = static_cast<int>(std::clamp(*parsed, -1L, 1000L));
    return parsed.has_value();
  };
  if (comma == std::string::npos || !number(std::string_view(text).substr(0, comma), orders.p) ||
      !number(std::string_view(text).substr(comma + 1), orders.q)) {
    throw std::invalid_argument(
        must_be("--derivatives", text, "two whole numbers p,q such as 1,1"));
  }
  return orders;
}

std::string coefficients_as_json(const FilterDefinition& definition,
                                 const CoefficientsOptions& options, Orders orders,
                                 const std::vector<Column>& columns) {
  ordered_json document{{"filter", definition.name},
                        {"derivatives", {orders.p, orders.q}},
                        {"normalization", options.normalization}};
  for (const auto& [name, values] : columns) {
    ordered_json rows = ordered_json::array();
    for (std::size_t i = 0; i < values.size(); ++i) {
      rows.push_back({{"index", i},
                      {"value", values[i].value},
                      {"radius", values[i].radius},
                      {"exact", values[i].exact ? ordered_json(*values[i].exact) : nullptr}});
    }
    document[name] = rows;
  }
  return io::json_text(document, 2) + "\n";
}

std::string coefficients_as_csv(const FilterDefinition& definition,
                                const std::vector<Column>& columns) {
  std::string text = "filter,quantity,index,value,radius,exact\n";
  for (const auto& [name, values] : columns) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      text += fmt::format("{},{},{},{},{},{}\n", io::csv_field(definition.name), name, i,
                          values[i].value, values[i].radius, values[i].exact.value_or(""));
    }
  }
  return text;
}

std::string coefficients_as_cpp(const FilterDefinition& definition,
                                const CoefficientsOptions& options,
                                const std::vector<Column>& columns) {
  std::string text = header_opening(
      fmt::format("Connection coefficients of {}, derivatives {}, normalization {}, indices from 0",
                  definition.name, options.derivatives, options.normalization),
      definition.name);
  for (const auto& [name, values] : columns) {
    std::vector<std::string> decimals;
    for (const auto& value : values) decimals.push_back(value.value);
    text += header_array(name, decimals);
  }
  return text + header_closing(definition.name);
}

std::string coefficients_as_text(const FilterDefinition& definition,
                                 const CoefficientsOptions& options, Orders orders,
                                 const std::vector<Column>& columns) {
  std::string text = fmt::format(
      "connection coefficients of {}, derivatives {},{}, normalization {}\n"
      "{} in the index; beyond the last index zero\n",
      printable(definition.name), orders.p, orders.q, options.normalization,
      (orders.p + orders.q) % 2 == 0 ? "symmetric" : "mu and nu antisymmetric");
  constexpr std::size_t longest_fraction = 40;
  for (const auto& [name, values] : columns) {
    text += fmt::format("\n{}\n", name);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto& [value, radius, exact] = values[i];
      text +=
          fmt::format("{:>6}  {}{}  +- {}", i, value.starts_with('-') ? "" : " ", value, radius);
      if (exact && exact->size() <= longest_fraction) text += "  = " + *exact;
      text += "\n";
    }
  }
  return text;
}

/// The sequences side by side, with the largest radius of each; fractions are left to the other formats.
MarkupTable coefficients_as_markup(const FilterDefinition& definition,
                                   const CoefficientsOptions& options, Orders orders,
                                   const std::vector<Column>& columns) {
  MarkupTable table{
      fmt::format("Connection coefficients of {}, derivatives {},{}, normalization {}",
                  definition.name, orders.p, orders.q, options.normalization),
      {"index"},
      {},
      {}};
  std::size_t size = 0;
  for (const Column& column : columns) size = std::max(size, column.values.size());
  for (std::size_t i = 0; i < size; ++i) table.rows.push_back({std::to_string(i)});
  for (const auto& [name, values] : columns) {
    table.columns.emplace_back(name);
    for (std::size_t i = 0; i < size; ++i) {
      table.rows[i].push_back(i < values.size() ? values[i].value : "");
    }
    table.notes.push_back(fmt::format("{}: {}", name, accuracy_text(values)));
  }
  return table;
}

/// What is printed instead of alpha, mu and nu, if anything.
std::optional<std::string> other_numbers(const CoefficientsOptions& options) {
  const std::string &name = options.name, &format = options.format;
  const int digits = options.digits;
  constexpr int usual_moments = 10;
  if (options.quantity) {
    return quantity_output(name, *options.quantity,
                           {digits, options.level, options.moments.value_or(usual_moments)},
                           format);
  }
  if (options.integral) {
    IntegralRange range = options.range;
    range.level = options.level;
    return integral_output(name, *options.integral, range, digits, format);
  }
  if (options.named_operator) {
    OperatorRange range = options.operator_range;
    range.period = options.range.period;
    return operator_output(name, *options.named_operator, range, digits, format);
  }
  if (options.moments) return moments_output(name, *options.moments, digits, format);
  return std::nullopt;
}

void run_coefficients(const CoefficientsOptions& options) {
  if (const auto text = other_numbers(options)) {
    std::fwrite(text->data(), 1, text->size(), stdout);
    return;
  }
  const Orders orders = parse_orders(options.derivatives);
  const FilterDefinition definition = io::load_filter(options.name);
  const auto [alpha, mu, nu] = certified::certified_decimals(
      definition, {.p = orders.p,
                   .q = orders.q,
                   .digits = options.digits,
                   .divide_by_first = options.normalization == "first"});
  const std::vector<Column> columns{{"alpha", alpha}, {"mu", mu}, {"nu", nu}};
  std::string text;
  if (options.format == "json") text = coefficients_as_json(definition, options, orders, columns);
  if (options.format == "csv") text = coefficients_as_csv(definition, columns);
  if (options.format == "cpp") text = coefficients_as_cpp(definition, options, columns);
  if (options.format == "text") text = coefficients_as_text(definition, options, orders, columns);
  if (is_markup(options.format)) {
    text = to_markup(coefficients_as_markup(definition, options, orders, columns), options.format);
  }
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_coefficients_command(CLI::App& app, ExitCode&) {
  auto options = std::make_shared<CoefficientsOptions>();
  CLI::App* command =
      app.add_subcommand("coefficients", "Print certified connection coefficients alpha, mu, nu");
  command->add_option("NAME", options->name, "Filter name, or path to a JSON filter file")
      ->required();
  CLI::Option* derivatives = command->add_option("--derivatives", options->derivatives,
                                                 "Orders p,q of the two derivatives");
  derivatives->capture_default_str();
  CLI::Option* quantity = command->add_option(
      "--quantity", options->quantity,
      "Print one quantity instead, in the words of `check`:\n" + verification::quantities_help());
  CLI::Option* integral = command->add_option(
      "--integral", options->integral,
      "Print the integrals of products of up to four factors: \"phi' phi(l) phi(m)\" is the integral\n"
      "of phi'(x) phi(x - l) phi(x - m) for all l, m. Factors are phi, psi, phi~, psi~, with primes\n"
      "or ^(p) for derivatives and (l) or (2x - l) for the shift and the level, and x^p");
  integral->excludes(quantity);
  CLI::Option* period =
      command
          ->add_option("--period", options->range.period,
                       "With --integral or --operator: make the factors periodic, and\n"
                       "integrate over one period")
          ->check(whole_number_from(1, most_integrals));
  command
      ->add_option("--on", options->range.on,
                   "A,B: integrate from A to B, integers or dyadic points, not over the line;\n"
                   "\"phi(l) phi'(m)\", with a letter for every factor. 0,x: from 0 to every x,\n"
                   "which is the first index; \"phi'(l) phi\", with one factor without a letter")
      ->needs(integral)
      ->excludes(period);
  CLI::Option* level =
      command
          ->add_option("--level", options->level,
                       "Values of phi and psi, or the ends x of --on 0,x, at k / 2^LEVEL")
          ->check(whole_number_from(0, certified::highest_dyadic_level))
          ->capture_default_str();
  CLI::Option* moments =
      command
          ->add_option(
              "--moments", options->moments,
              "Print moments of phi and psi up to this, the coefficients by which phi reproduces\n"
              "polynomials, and weights of quadrature; with --quantity the highest of moment(...)")
          ->check(whole_number_from(0, certified::highest_moment));
  CLI::Option* named_operator = command->add_option(
      "--operator", options->named_operator,
      "Print int phi(x - l) (T phi)(x) dx of the operator T: hilbert, riesz:S (of the symbol |w|^S),\n"
      "hilbert:S (the Hilbert transform of riesz:S), fractional:S (the derivative of\n"
      "order S, or the integral of order -S), derivative:K");
  command
      ->add_option("--up-to", options->operator_range.largest, "With --operator: the largest |l|")
      ->check(whole_number_from(0, certified::largest_shift))
      ->capture_default_str()
      ->needs(named_operator)
      ->excludes(period);
  add_digits_option(*command, options->digits);
  CLI::Option* normalize = command->add_option("--normalize", options->normalization,
                                               "Divide mu and nu by their index 0");
  normalize->check(CLI::IsMember({"none", "first"}))->capture_default_str();
  add_format_option(*command, options->format, {"text", "json", "csv", "cpp", "markdown", "latex"});
  for (CLI::Option* of_sequences : {derivatives, normalize}) {
    of_sequences->excludes(quantity, integral, moments, named_operator);
  }
  named_operator->excludes(quantity, integral, moments);
  integral->excludes(moments);
  command->callback([=] {
    const bool has_points =
        !quantity->empty() || (options->range.on && verification::is_up_to_x(*options->range.on));
    if (!level->empty() && !has_points) {
      throw std::invalid_argument("--level takes --quantity or --on 0,x");
    }
    if (!period->empty() && integral->empty() && named_operator->empty()) {
      throw std::invalid_argument("--period takes --integral or --operator");
    }
    run_coefficients(*options);
  });
}

}  // namespace wavecurve::tools
