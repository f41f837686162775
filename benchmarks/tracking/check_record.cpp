#include "benchmarks/tracking/check_record.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "wavecurve/io/files/detail/json_place.hpp"

namespace wavecurve::tracking {

namespace {

using Place = io::OrderedJsonPlace;

void check_kernel(const Place& kernel) {
  kernel.at("size").whole_number(1, std::numeric_limits<int>::max());
  for (const char* count : {"instructions", "data_reads", "data_writes"}) {
    const Place place = kernel.at(count);
    if (!(place.number() > 0)) place.refuse("above 0");
  }
}

void check_accuracy(const Place& accuracy) {
  constexpr std::array kinds{"error", "iterations", "digits"};
  const Place kind = accuracy.at("kind");
  if (std::ranges::find(kinds, kind.text()) == kinds.end()) {
    kind.refuse("error, iterations or digits");
  }
  // What is no number is null in JSON.
  const Place value = accuracy.at("value");
  if (!value.value().is_null()) value.number();
}

void check_benchmark(const Place& benchmark) {
  benchmark.at("program").text();
  benchmark.at("name").text();
  const auto times = benchmark.find("cpu_time");
  if (!times) return;  // it failed
  benchmark.at("time_unit").text();
  if (times->elements().empty()) times->refuse("a list of at least one time");
  for (const Place& time : times->elements()) {
    if (!(time.number() > 0)) time.refuse("above 0");
  }
}

void check_revision(const Place& revision) {
  revision.items();
  if (const auto commit = revision.find("commit")) commit->text();
  const auto is_dirty = revision.find("is_dirty");
  if (is_dirty && !is_dirty->value().is_boolean()) is_dirty->refuse("true or false");
}

}  // namespace

void check_record(const Json& record) {
  const Place document(record);
  if (const auto date = document.find("date")) date->text();
  if (const auto revision = document.find("revision")) check_revision(*revision);
  for (const char* key : {"environment", "valgrind", "machine"}) {
    if (const auto object = document.find(key)) object->items();
  }
  if (const auto machine = document.find("machine")) {
    if (const auto cpu = machine->find("cpu")) cpu->text();
  }
  if (const auto kernels = document.find("kernels")) {
    for (const auto& [name, kernel] : kernels->items()) check_kernel(kernel);
  }
  if (const auto accuracies = document.find("accuracy")) {
    for (const auto& [name, accuracy] : accuracies->items()) check_accuracy(accuracy);
  }
  if (const auto benchmarks = document.find("benchmarks")) {
    for (const Place& benchmark : benchmarks->elements()) check_benchmark(benchmark);
  }
}

}  // namespace wavecurve::tracking
