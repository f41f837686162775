#pragma once

#include <string>
#include <vector>

namespace wavecurve::verification {

/// What a list of low-pass taps is by its own equations, when it is not the filter that it is
/// called: "an orthonormal filter of this length with 4 vanishing moments of psi and 3 of phi about
/// its centre: a coiflet, another solution of the same equations". Empty unless the taps, brought to
/// the sum sqrt 2, are orthonormal to 1e-6 and have at least half as many vanishing moments as a
/// filter of their length can have, or as a coiflet of it.
///
/// In double precision: it describes, it does not judge.
std::string describe_solution(const std::vector<double>& taps);

}  // namespace wavecurve::verification
