#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace wavecurve::io {

/// A value of a JSON document together with where it stands, "dual.taps[3]"; documents from outside
/// are read through this alone, for the operator [] of a constant document is undefined for a key
/// that is not there. What is not as it should be throws std::invalid_argument: "dual.taps[3] is
/// null, but must be ...". The document must outlive it.
template <class Json>
class BasicJsonPlace {
 public:
  explicit BasicJsonPlace(const Json& document) : value_(&document) {}

  const Json& value() const { return *value_; }

  /// Throws unless it is an object with no other keys than these; names the nearest key.
  void check_keys(const std::vector<std::string>& known) const;
  /// The value under a key, if it is there; of what is no object, nothing.
  std::optional<BasicJsonPlace> find(const std::string& key) const;
  /// Throws if it is not there.
  BasicJsonPlace at(const std::string& key) const;

  /// Throws unless it is a list, and has so many elements where a number is given.
  std::vector<BasicJsonPlace> elements(std::optional<std::size_t> size = std::nullopt) const;
  /// Keys and values in the document's order. Throws unless it is an object.
  std::vector<std::pair<std::string, BasicJsonPlace>> items() const;
  bool is_null() const { return value_->is_null(); }
  /// Throws unless it is true or false.
  bool boolean() const;
  /// Throws unless it is a text.
  std::string text() const;
  /// Throws unless it is one of these texts.
  std::string one_of(const std::vector<std::string>& known) const;
  /// Throws unless it is a whole number from `least` to `most`.
  int whole_number(int least, int most) const;

  /// Throws unless it is a finite number, from `least` to `most`.
  double number(double least = std::numeric_limits<double>::lowest(),
                double most = std::numeric_limits<double>::max()) const;

  [[noreturn]] void refuse(const std::string& bound) const;

 private:
  BasicJsonPlace(const Json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  const Json* value_;
  std::string path_;
};

using JsonPlace = BasicJsonPlace<nlohmann::json>;
using OrderedJsonPlace = BasicJsonPlace<nlohmann::ordered_json>;

/// Throws unless "format" and "version" are what is read here.
void check_kind(const JsonPlace& document, const std::string& format, int version);

}  // namespace wavecurve::io
