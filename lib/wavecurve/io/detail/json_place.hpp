#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace wavecurve::io {

/// A value of a JSON document together with where it stands, "dual.taps[3]". What is not as it
/// should be throws std::invalid_argument: "dual.taps[3] is null, but must be ...". The document
/// must outlive it.
class JsonPlace {
 public:
  explicit JsonPlace(const nlohmann::json& document) : value_(&document) {}

  const nlohmann::json& value() const { return *value_; }

  /// Throws unless it is an object with no other keys than these; names the nearest key.
  void check_keys(const std::vector<std::string>& known) const;
  /// The value under a key, if it is there; of what is no object, nothing.
  std::optional<JsonPlace> find(const std::string& key) const;
  /// Throws if it is not there.
  JsonPlace at(const std::string& key) const;

  /// Throws unless it is a list.
  std::vector<JsonPlace> elements() const;
  /// Throws unless it is a text.
  std::string text() const;
  /// Throws unless it is a whole number from `least` to `most`.
  int whole_number(int least, int most) const;

  [[noreturn]] void refuse(const std::string& bound) const;

 private:
  JsonPlace(const nlohmann::json& value, std::string path)
      : value_(&value), path_(std::move(path)) {}

  const nlohmann::json* value_;
  std::string path_;
};

}  // namespace wavecurve::io
