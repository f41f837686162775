#pragma once

#include "verification/study/study_ranks.hpp"

/// The one function of the module: the processes that mpirun has started, for whom it is to be deleted
/// by. MPI is begun by it and ended when they are gone.
extern "C" wavecurve::verification::Ranks* wavecurve_open_ranks();
