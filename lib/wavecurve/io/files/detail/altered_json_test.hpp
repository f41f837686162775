#pragma once

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wavecurve::io {

// For tests of readers: the ways in which one place of a document may be other than it should.

template <class Json>
using Pointer = typename Json::json_pointer;

/// Every place of a document, of the elements of a list the first and the last alone.
template <class Json>
void add_places(const Json& json, const Pointer<Json>& here, std::vector<Pointer<Json>>& places) {
  places.push_back(here);
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) add_places(value, here / key, places);
  }
  if (!json.is_array()) return;
  for (const std::size_t i : std::set<std::size_t>{0, json.size() - 1}) {
    if (i < json.size()) add_places(json.at(i), here / i, places);
  }
}

/// The document with one place altered or, but for the whole, removed.
template <class Json>
std::vector<Json> altered(const Json& document) {
  const std::vector<Json> others{
      nullptr, -1, 0.5, 1e300, 18446744073709551615U, "x", false, Json::array(), Json::object()};
  std::vector<Pointer<Json>> places;
  add_places(document, Pointer<Json>(), places);
  std::vector<Json> result;
  for (const Pointer<Json>& place : places) {
    for (const Json& other : others) {
      result.push_back(document);
      result.back()[place] = other;
    }
    if (place.empty()) continue;
    result.push_back(document);
    Json& parent = result.back()[place.parent_pointer()];
    if (parent.is_object()) {
      parent.erase(place.back());
    } else {
      parent.erase(parent.begin() + std::stol(place.back()));
    }
  }
  return result;
}

/// Expects that each is read, or refused in one sentence of our own; `refusal` gives it, or nothing.
/// Returns how many were refused.
template <class Json, class Refusal>
int refused_of(const std::vector<Json>& documents, Refusal refusal) {
  int refused = 0;
  for (const Json& document : documents) {
    const std::string message = refusal(document);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.find("json.exception"), std::string::npos) << message;
    refused += message.empty() ? 0 : 1;
  }
  return refused;
}

}  // namespace wavecurve::io
