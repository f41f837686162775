#include "benchmarks/pages/peers.hpp"

#include <fmt/format.h>

#include "wavecurve/io/files/detail/json_place.hpp"
#include "wavecurve/io/files/detail/parse_json.hpp"
#include "wavecurve/io/files/detail/run_program.hpp"

namespace wavecurve::tracking {

namespace {

namespace fs = std::filesystem;
using Timer = std::function<double()>;

/// Makes timers, and collects the pairs.
class Pairs {
 public:
  Pairs(const Build& build, const fs::path& root, const PeersOptions& options)
      : build_(build), root_(root), options_(options) {}

  Timer benchmark(const std::string& program, const std::string& name) const {
    return [program = build_.programs / program, name, seconds = options_.seconds] {
      return time_once(program, name, seconds);
    };
  }
  /// A script that prints seconds.
  Timer script(std::vector<std::string> arguments) const {
    arguments[0] = (root_ / "benchmarks" / "peers" / arguments[0]).string();
    arguments.insert(arguments.begin(), "/usr/bin/python3");
    return [arguments] {
      const Json printed = io::parse_ordered_json(io::output_of(arguments));
      const io::OrderedJsonPlace place(printed);
      return place.find("seconds").value_or(place).number();
    };
  }
  /// A counter of a benchmark, which is the same in every run.
  double counter(const std::string& program, const std::string& name,
                 const std::string& key) const {
    return run_benchmark(build_.programs / program, name, 0).front().value(key, 0.0);
  }
  void add(Peer peer, Timer own, Timer theirs) {
    peers_.push_back(std::move(peer));
    pairs_.push_back(
        {peers_.back().work + ", " + peers_.back().name, std::move(own), std::move(theirs)});
  }

  std::vector<PeerResult> run(const Say& say) const {
    const auto times = time_interleaved(pairs_, options_.blocks, 1996, say);
    std::vector<PeerResult> results;
    for (std::size_t i = 0; i < peers_.size(); ++i) {
      std::vector<double> own, theirs;
      for (const Block& block : times[i]) {
        own.insert(own.end(), {block.a_first, block.a_second});
        theirs.insert(theirs.end(), {block.b_first, block.b_second});
      }
      results.push_back({peers_[i], median(own), median(theirs), bootstrap_ratio(times[i])});
    }
    return results;
  }

 private:
  const Build& build_;
  const fs::path& root_;
  const PeersOptions& options_;
  std::vector<Peer> peers_;
  std::vector<TimedPair> pairs_;
};

void add_transforms(Pairs& pairs) {
  for (const int exponent : {14, 18, 22}) {
    const std::string samples = std::to_string(1 << exponent);
    for (const std::string direction : {"forward", "inverse"}) {
      const std::string own = "double/" + direction + "/db4/single/" + samples;
      const bool is_forward = direction == "forward";
      const auto add = [&](const std::string& name, const Timer& theirs, const std::string& note) {
        pairs.add(
            {"transform", fmt::format("transform {}, N = 2^{}", direction, exponent), name, note},
            pairs.benchmark("transform_benchmark", own), theirs);
      };
      add("GSL",
          pairs.benchmark("transform_benchmark", "gsl<Direction::" + direction + ">/" + samples),
          "in place, and a copy");
      add("PyWavelets core",
          pairs.script({"transform_pywavelets.py", is_forward ? "dwt" : "idwt", samples}),
          "its compiled dwt, level by level");
      add("PyWavelets call",
          pairs.script({"transform_pywavelets.py", is_forward ? "wavedec" : "waverec", samples}),
          "");
      if (is_forward)
        add("plain loop", pairs.benchmark("transform_benchmark", "plain_loop/" + samples),
            "(2.8) as written");
      add("memcpy", pairs.benchmark("transform_benchmark", "copy/" + samples),
          "the physical limit");
    }
  }
}

void add_coefficients(Pairs& pairs) {
  for (const std::string order : {"5", "10", "19"}) {
    pairs.add({"coefficients", "db" + order + ", 50 digits", "mpmath",
               "LU of the two-scale system, no bound of the error"},
              pairs.benchmark("certified_benchmark", "daubechies_mu_50_digits/" + order),
              pairs.script({"connection_mpmath.py", order, "50"}));
  }
  for (const std::string order : {"3", "4"}) {
    pairs.add({"coefficients", "db" + order + ", three factors, 40 digits", "mpmath",
               "LU of the two-scale system, no bound of the error"},
              pairs.benchmark("certified_benchmark", "three_terms_40_digits/" + order),
              pairs.script({"three_terms_mpmath.py", order, "40"}));
  }
}

void add_motion(Pairs& pairs) {
  const auto add = [&](const std::string& own, const std::string& name, const std::string& theirs) {
    const std::string a = "solve_end/" + own + "/256", b = theirs + "/256";
    const auto error = [&](const std::string& benchmark) {
      return pairs.counter("dynamics_benchmark", benchmark, "error");
    };
    const std::string ours =
        own == "spectral" ? "ours is the exact solution" : fmt::format("error {:.1e}", error(a));
    pairs.add({"motion", own, name, fmt::format("{}, the peer's {:.1e}", ours, error(b))},
              pairs.benchmark("dynamics_benchmark", a), pairs.benchmark("dynamics_benchmark", b));
  };
  for (const std::string own : {"spectral", "coupled_1e6", "coupled_1e8"}) {
    const bool is_rough = own == "coupled_1e6";
    const std::string tolerance = is_rough ? "1e6" : "1e8";
    add(own, "CVODE Adams " + tolerance, "sundials_peer/cvode_adams_" + tolerance);
    add(own, "CVODE BDF " + tolerance, "sundials_peer/cvode_bdf_" + tolerance);
    add(own, "ARKODE ERK " + tolerance, "sundials_peer/arkode_" + tolerance);
  }
  add("coupled_1e6", "Odeint, dense matrix", "solve_end/coupled_dense_1e6");
}

void add_curves(Pairs& pairs) {
  pairs.add({"curves", "start point, 4096 points", "every shift", ""},
            pairs.benchmark("motion_benchmark", "correspondence/4096"),
            pairs.benchmark("motion_benchmark", "exhaustive_correspondence/4096"));
  pairs.add({"curves", "crossings, 1024 points", "every pair of edges", ""},
            pairs.benchmark("motion_benchmark", "crossings/1024"),
            pairs.benchmark("motion_benchmark", "plain_crossings/1024"));
}

}  // namespace

std::vector<PeerResult> time_peers(const Build& build, const fs::path& root,
                                   const PeersOptions& options, const Say& say) {
  Pairs pairs(build, root, options);
  add_transforms(pairs);
  add_coefficients(pairs);
  add_motion(pairs);
  add_curves(pairs);
  return pairs.run(say);
}

}  // namespace wavecurve::tracking
