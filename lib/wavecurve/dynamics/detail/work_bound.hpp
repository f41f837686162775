#pragma once

namespace wavecurve::dynamics {

/// What a solver may take, in operations as Cost counts them: some ten seconds.
constexpr double most_operations = 5e10;

/// Throws std::domain_error if a solver that has got so far, in so many operations, would need more
/// than most_operations to the end at that rate. It is not judged before the second or so that
/// most_operations / 50 take, for the first steps are the shortest. So explicit methods refuse stiff
/// problems at once: their steps are bounded by stability, however smooth the motion is.
void check_work(long long operations, double time, double end);

/// The same of a solver whose steps grow as the motion becomes smooth: it is refused once it has taken
/// so many operations.
void check_work(long long operations);

}  // namespace wavecurve::dynamics
