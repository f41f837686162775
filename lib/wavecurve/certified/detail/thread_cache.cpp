#include "wavecurve/certified/detail/thread_cache.hpp"

#include "wavecurve/certified/flint.hpp"

namespace wavecurve::certified {

ThreadCache::~ThreadCache() { flint_cleanup(); }

}  // namespace wavecurve::certified
