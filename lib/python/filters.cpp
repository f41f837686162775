// Filter banks.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <utility>

#include "wavecurve/certified/detail/rounded_values.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/nearest_filter_bank.hpp"
#include "wavecurve/certified/user_filter.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/filter_tables.hpp"
#include "wavecurve/io/filter_json.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "python/filter_source.hpp"
#include "python/interruptible.hpp"
#include "python/numbers.hpp"
#include "python/topics.hpp"

namespace wavecurve::python {

namespace {

using certified::Ball;
using certified::DecimalEnclosure;

/// A file is read once: what it says is kept, so that the bank stays what it was.
FilterSource source_of(const std::string& name_or_path) {
  if (name_or_path.ends_with(".json")) return {io::read_filter_json(name_or_path)};
  return {name_or_path};
}

FilterBank<double> bank_of(const FilterSource& source) {
  if (const auto* name = std::get_if<std::string>(&source.origin)) {
    return io::load_filter_bank(*name);
  }
  return certified::nearest_filter_bank(source.define());
}

constexpr auto filter_names = {"analysis_low", "analysis_high", "synthesis_low", "synthesis_high"};

template <class Scalar>
const Filter<Scalar>& one_of(const FilterBank<Scalar>& bank, const std::string& which) {
  if (which == "analysis_low") return bank.analysis_low;
  if (which == "analysis_high") return bank.analysis_high;
  if (which == "synthesis_low") return bank.synthesis_low;
  if (which == "synthesis_high") return bank.synthesis_high;
  throw std::invalid_argument(unknown_name("filter of a bank", which, filter_names));
}

py::tuple taps(const PythonFilter& self, const std::string& which) {
  const Filter<double>& filter = one_of(self.bank, which);
  return py::make_tuple(
      filter.first_index,
      py::array_t<double>(static_cast<py::ssize_t>(filter.taps.size()), filter.taps.data()));
}

py::tuple tap_decimals(const PythonFilter& self, const std::string& which, int digits) {
  one_of(self.bank, which);
  const bool synthesis = which == "synthesis_low" || which == "analysis_high";
  const auto numbers = interruptible([source = self.source, which, digits, synthesis] {
    const certified::FilterDefinition definition = source.define();
    return certified::rounded_values(
        [&](long bits) { return one_of(definition.bank(bits), which).taps; }, digits,
        synthesis ? definition.known_bits : definition.dual_known_bits);
  });
  return py::make_tuple(one_of(self.bank, which).first_index, to_python(numbers));
}

using Taps = std::pair<int, std::vector<std::string>>;

Filter<std::string> filter_of(const Taps& taps) { return {taps.first, taps.second}; }

PythonFilter filter_of_taps(const std::string& name, const Taps& synthesis,
                            const std::optional<Taps>& analysis, const std::string& sum,
                            const std::optional<int>& vanishing_moments,
                            const std::optional<int>& dual_vanishing_moments,
                            const std::optional<std::string>& accuracy) {
  UserFilter user{.name = name, .taps = filter_of(synthesis)};
  if (analysis) user.dual = filter_of(*analysis);
  user.sum = sum;
  user.vanishing_moments = vanishing_moments;
  user.dual_vanishing_moments = dual_vanishing_moments;
  user.accuracy = accuracy;
  return PythonFilter({std::move(user)});
}

py::tuple state_of(const PythonFilter& self) {
  if (const auto* name = std::get_if<std::string>(&self.source.origin))
    return py::make_tuple(*name);
  const UserFilter& user = std::get<UserFilter>(self.source.origin);
  const auto taps_of = [](const Filter<std::string>& f) { return Taps(f.first_index, f.taps); };
  std::optional<Taps> dual;
  if (user.dual) dual = taps_of(*user.dual);
  return py::make_tuple(user.name, taps_of(user.taps), dual, user.sum, user.vanishing_moments,
                        user.dual_vanishing_moments, user.dual_sum, user.accuracy,
                        user.dual_accuracy);
}

PythonFilter filter_of_state(const py::tuple& state) {
  if (state.size() == 1) return PythonFilter({state[0].cast<std::string>()});
  UserFilter user{.name = state[0].cast<std::string>(), .taps = filter_of(state[1].cast<Taps>())};
  if (const auto dual = state[2].cast<std::optional<Taps>>()) user.dual = filter_of(*dual);
  user.sum = state[3].cast<std::string>();
  user.vanishing_moments = state[4].cast<std::optional<int>>();
  user.dual_vanishing_moments = state[5].cast<std::optional<int>>();
  user.dual_sum = state[6].cast<std::optional<std::string>>();
  user.accuracy = state[7].cast<std::optional<std::string>>();
  user.dual_accuracy = state[8].cast<std::optional<std::string>>();
  return PythonFilter({std::move(user)});
}

py::dict aliases() {
  py::dict result;
  for (const auto& [alias, name] : filter_aliases()) {
    result[py::str(std::string(alias))] = std::string(name);
  }
  return result;
}

}  // namespace

certified::FilterDefinition FilterSource::define() const {
  if (const auto* name = std::get_if<std::string>(&origin)) return certified::find_filter(*name);
  return certified::define_user_filter(std::get<UserFilter>(origin));
}

PythonFilter::PythonFilter(FilterSource from) : source(std::move(from)), bank(bank_of(source)) {}

void add_filters(py::module_& module) {
  py::class_<PythonFilter>(module, "NativeFilterBank",
                           "A filter bank; wavecurve.FilterBank adds the rest.")
      .def(py::init([](const std::string& text) { return PythonFilter(source_of(text)); }),
           py::arg("name_or_path"))
      .def_static("from_taps", &filter_of_taps, py::arg("name"), py::arg("synthesis"),
                  py::arg("analysis"), py::arg("sum"), py::arg("vanishing_moments"),
                  py::arg("dual_vanishing_moments"), py::arg("accuracy"))
      .def_property_readonly("name", [](const PythonFilter& f) { return f.bank.name; })
      .def_property_readonly("vanishing_moments",
                             [](const PythonFilter& f) { return f.bank.vanishing_moments; })
      .def_property_readonly("dual_vanishing_moments",
                             [](const PythonFilter& f) { return f.bank.dual_vanishing_moments; })
      .def_property_readonly("sobolev_exponent",
                             [](const PythonFilter& f) { return f.bank.sobolev_exponent; })
      .def_property_readonly("is_orthonormal",
                             [](const PythonFilter& f) { return f.bank.is_orthonormal(); })
      .def("taps", &taps, py::arg("which"))
      .def("decimals", &tap_decimals, py::arg("which"), py::arg("digits"))
      .def(py::pickle(&state_of, &filter_of_state));
  module.def("filter_names", &certified::filter_names, "Every canonical name.");
  module.def("filter_aliases", &aliases, "The other names, and what they stand for.");
}

}  // namespace wavecurve::python
