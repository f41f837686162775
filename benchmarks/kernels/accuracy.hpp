#pragma once

#include <string>
#include <vector>

namespace wavecurve::tracking {

/// How good a result is, computed anew at every run: no smaller matter than how fast.
struct Accuracy {
  std::string name;
  std::string kind;  ///< "error" and "iterations": less is better; "digits": more is
  double value;
};

/// Round trips, errors of solvers against the exact one and what they took, digits proved.
std::vector<Accuracy> measure_accuracy();

}  // namespace wavecurve::tracking
