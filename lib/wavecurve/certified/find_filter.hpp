#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// The filter of a canonical name or an alias: db1-db38 (haar, D2-D76, d2-d76), sym2-sym20
/// (la8-la20), coif1-coif17 (K1-K17, c6-c102), bsplineD.E for every D >= 1, E >= 1 with D + E even
/// (bior1.1-bior3.9, legall), cdf9.7 (bior4.4), bior5.5, bior6.8, and rbioD.E, which is biorD.E with
/// its two sides exchanged. docs/conventions.md says what each means. Throws std::invalid_argument
/// with a message that names the text and what is accepted, or, of a filter that other packages have
/// ("fk8", "dmey"), what it is and why it is not among these.
FilterDefinition find_filter(std::string_view name);

/// The canonical name of a name or alias. Throws as find_filter does.
std::string canonical_filter_name(std::string_view name);

/// Every canonical name of the finite families; the splines, being infinitely many, up to order 9.
std::vector<std::string> filter_names();

}  // namespace wavecurve::certified
