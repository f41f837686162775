#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "wavecurve/certified/decimal_enclosure.hpp"

namespace wavecurve::tools {

/// A certified number with the indices that it stands at.
struct ListedNumber {
  std::string index;               ///< "3", "1/2", "(2, -1)"
  nlohmann::ordered_json indices;  ///< the same as an array
  certified::DecimalEnclosure number;
  std::string quantity = {};  ///< what it is, where a list holds several; they stand together
};

/// Numbers of one kind of one filter, for all formats.
struct NumberList {
  std::string filter;
  std::string name;             ///< "int(phi', phi, phi)"
  nlohmann::ordered_json head;  ///< what JSON has between the filter and the entries
  std::vector<ListedNumber> entries;
};

/// "3", or "(2, -1)" for several.
ListedNumber listed(const std::vector<int>& indices, certified::DecimalEnclosure number);

/// As text, json, csv, cpp, markdown or latex.
std::string number_list_output(const NumberList& list, const std::string& format);

}  // namespace wavecurve::tools
