#pragma once

#include <string>
#include <vector>

#include "benchmarks/pages/peers_page.hpp"
#include "benchmarks/tracking/bootstrap.hpp"

namespace wavecurve::tracking {

/// One piece of work that a peer does too.
struct Peer {
  std::string group, work, name, note;
};

struct PeerResult {
  Peer peer;
  double own_seconds, peer_seconds;  ///< medians
  RatioInterval ratio;               ///< the peer's time over ours
};

/// Runs all pairs, interleaved. Throws std::runtime_error where a program fails.
std::vector<PeerResult> time_peers(const Build& build, const std::filesystem::path& root,
                                   const PeersOptions& options, const Say& say);

}  // namespace wavecurve::tracking
