#pragma once

namespace wavecurve::certified {

/// While it lives, the thread may compute with enclosures; then the memory that FLINT keeps for the
/// thread is given back, which FLINT does not do by itself. For every thread but the main one. Put
/// it before all values of the certified types.
class ThreadCache {
 public:
  ThreadCache() = default;
  ~ThreadCache();
  ThreadCache(const ThreadCache&) = delete;
  ThreadCache& operator=(const ThreadCache&) = delete;
};

}  // namespace wavecurve::certified
