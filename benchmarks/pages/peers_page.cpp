#include "benchmarks/pages/peers_page.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"
#include "wavecurve/io/files/detail/temporary.hpp"
#include "wavecurve/io/files/write_file.hpp"

#include "benchmarks/pages/peers.hpp"
#include "benchmarks/tracking/change.hpp"
#include "benchmarks/tracking/machine_fingerprint.hpp"
#include "benchmarks/tracking/make_record.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;
using verification::Paragraph;
using verification::Table;

std::string time_text(double seconds) {
  if (seconds < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
  return seconds < 1e-3 ? fmt::format("{:.3g} µs", seconds * 1e6)
                        : fmt::format("{:.3g} ms", seconds * 1e3);
}

/// A win, a loss or neither, by the same rule as a change of time.
std::string result_of(const RatioInterval& ratio) {
  switch (judge_time(ratio, Thresholds().time)) {
    case Change::slower:
      return "win";
    case Change::faster:
      return "loss";
    case Change::same:
      return "equal";
    case Change::inconclusive:
      break;
  }
  return "open";
}

std::vector<std::string> cells(const PeerResult& result) {
  return {result.peer.work,
          result.peer.name,
          time_text(result.own_seconds),
          time_text(result.peer_seconds),
          fmt::format("{:.3g}", result.ratio.ratio),
          fmt::format("{:.3g} .. {:.3g}", result.ratio.lower, result.ratio.upper),
          result_of(result.ratio),
          result.peer.note};
}

Table table_of(const std::string& caption, const std::vector<PeerResult>& results,
               const std::string& group) {
  Table table{caption,
              {"work", "peer", "ours", "peer's", "peer / ours", "99 % interval", "result", "note"},
              {}};
  for (const PeerResult& result : results) {
    if (result.peer.group == group) table.rows.push_back(cells(result));
  }
  return table;
}

/// Why each loss is one, by what was measured of it.
struct Reason {
  std::string work, peer, why;
};
const std::vector<Reason> reasons{
    {"transform", "memcpy",
     "A copy is the physical limit, not a peer. Within the caches shuffles bound the transform: 16 "
     "samples of a level are 10 multiplications, 8 additions and 5 shuffles of 512 bits; beyond "
     "them three levels pass at once, which reads and writes half as much again (head of "
     "benchmarks/transform_benchmark.cpp, with what was tried)."},
};

std::string reason_for(const PeerResult& result) {
  for (const Reason& reason : reasons) {
    if (result.peer.work.starts_with(reason.work) && result.peer.name == reason.peer) {
      return reason.why;
    }
  }
  return "not yet known";
}

Table losses(const std::vector<PeerResult>& results) {
  Table table{"Where this library is slower, and why", {"work", "peer", "peer / ours", "why"}, {}};
  std::string last;
  for (const PeerResult& result : results) {
    if (result_of(result.ratio) != "loss") continue;
    const std::string why = reason_for(result);
    table.rows.push_back({result.peer.work, result.peer.name,
                          fmt::format("{:.3g}", result.ratio.ratio),
                          why == last ? "as above" : why});
    last = why;
  }
  if (table.rows.empty()) table.rows.push_back({"none", "", "", ""});
  return table;
}

/// Worst tap of each family, by table.
Table digits_table(const Build& build, const fs::path& root) {
  const io::Temporary folder(fs::temp_directory_path() / "peers", io::Temporary::Kind::folder);
  const fs::path file = folder.path() / "pywavelets.json";
  io::write_file(file,
                 io::output_of({"/usr/bin/python3",
                                (root / "lib/wavecurve/filters/pywavelets_tables.py").string()}));
  const Json digits = io::parse_ordered_json(
      io::output_of({(build.programs / "filter_digits").string(), file.string()}));
  Table table{
      "The worst tap of each family in units in the last place of a double, against "
      "enclosures of 128 bits; at most 0.5 is correctly rounded",
      {"family", "table", "filters", "worst tap, ulps", "in", "correct digits"},
      {}};
  for (const auto& [family, tables] : digits.items()) {
    for (const auto& [name, entry] : tables.items()) {
      const bool is_number = entry.at("worst_ulps").is_number();
      const double ulps = is_number ? entry.at("worst_ulps").get<double>() : 0;
      // An ulp is between 2^-53 and 2^-52 of the tap.
      const double decimals = 52 * std::log10(2.0) - std::log10(std::max(ulps, 0.5));
      table.rows.push_back({family, name, entry.at("filters").dump(),
                            is_number ? fmt::format("{:.3g}", ulps) : "another length",
                            entry.at("worst_filter").get<std::string>(),
                            is_number ? fmt::format("{:.1f}", decimals) : ""});
    }
  }
  return table;
}

std::string versions(const Build& build) {
  const Json environment = ask(build, "--environment");
  const std::string python = io::output_of(
      {"/usr/bin/python3", "-c",
       "import sys, numpy, pywt, mpmath; print('Python', sys.version.split()[0], 'NumPy', "
       "numpy.__version__, 'PyWavelets', pywt.__version__, 'mpmath', mpmath.__version__)"});
  const std::string libraries =
      io::output_of({(build.programs / "filter_digits").string(), "--versions"});
  return fmt::format("{}; flags {}; {}; {}; {}; processor times on {}, {} processors, shared.",
                     environment.at("compiler").get<std::string>(),
                     environment.at("flags").get<std::string>(), environment.at("libraries").dump(),
                     libraries, python, machine_fingerprint().at("cpu").get<std::string>(),
                     machine_fingerprint().at("processors").dump());
}

}  // namespace

reports::Page peers_page(const Build& build, const fs::path& root, const PeersOptions& options,
                         const Say& say) {
  const std::vector<PeerResult> results = time_peers(build, root, options, say);
  say("digits of filter tables");
  const Table digits = digits_table(build, root);
  const Paragraph how{
      "Each pair is timed in blocks ours, peer, peer, ours (or the other way round), every time by "
      "a process of its own, all pairs in random order in each round. The ratio is the median of "
      "the blocks, above 1 where the peer takes longer; its interval is a bootstrap one. A win or "
      "a loss needs an interval without 1 and 5 % of difference."};
  const std::string date = "Measured on " + date_now();
  return {
      "This library beside its peers",
      date,
      {{"Losses", {how, losses(results)}},
       {"Transform", {table_of("D8, all levels, double", results, "transform")}},
       {"Filters and their digits", {digits}},
       {"Connection coefficients",
        {table_of("mu of a Daubechies filter; ours with proof of every digit", results,
                  "coefficients")}},
       {"Equation of motion",
        {Paragraph{"An ellipse of 256 samples until t = 1. Errors are relative, of the state at "
                   "the end, against the exact solution: compare rows whose errors are alike."},
         table_of("The state at the end", results, "motion")}},
       {"Curves", {table_of("The same work by the definition", results, "curves")}},
       {"Versions and flags", {Paragraph{versions(build)}}}}};
}

}  // namespace wavecurve::tracking
