#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wavecurve::io {

/// The limb to which a joint belongs by its name: LF, RF, LH or RH where the name says which, as
/// LF_toe, toe_FL, front_left_paw and L_hind_hock do; else the first of several words, as in
/// tail_base, in upper case; empty where the name says no limb.
std::string limb_of_joint(std::string_view name);

/// How far from the body a joint is, if the word is known: a shoulder or hip 1, ..., a toe 7.
std::optional<int> rank_of_joint(std::string_view name);

}  // namespace wavecurve::io
