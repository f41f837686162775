#pragma once

#include <memory>

#include "verification/study/study_ranks.hpp"

namespace wavecurve::tools {

/// The processes that mpirun, or srun, has started together with this one; none if it was started
/// alone. Throws std::runtime_error if there are some, but no module for MPI was installed.
std::unique_ptr<verification::Ranks> started_ranks();

/// Whether mpirun has started this one together with others.
bool is_started_with_others();

/// Keeps this process on a core of its own. Throws std::invalid_argument if there are more processes
/// on this machine than cores, std::system_error if the system does not allow it.
void keep_to_a_core(const verification::Ranks& ranks);

}  // namespace wavecurve::tools
