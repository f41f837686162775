#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace wavecurve::io {

/// What a reader had to leave out, each once, in the order of appearance.
struct Warnings {
  std::vector<std::string> list;

  void add(std::string text) {
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
  }
};

}  // namespace wavecurve::io
