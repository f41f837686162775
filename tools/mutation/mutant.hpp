#pragma once

#include <cstdlib>

/// Included at the head of every file with planted mutants: the one whose number the environment
/// names is the only one that acts.
namespace mutation {

inline const int active = [] {
  const char* number = std::getenv("WAVECURVE_MUTANT");
  return number != nullptr ? std::atoi(number) : 0;
}();

inline bool is(int number) { return active == number; }

}  // namespace mutation
