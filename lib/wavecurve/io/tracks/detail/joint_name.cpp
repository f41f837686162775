#include "wavecurve/io/tracks/detail/joint_name.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

using Words = std::vector<std::string>;

/// The words of a name in lower case, also where only capitals part them: leftFrontPaw.
Words words_of(std::string_view name) {
  Words words;
  std::string spaced;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto is_lower = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (i > 0 && is_upper(name[i]) && is_lower(name[i - 1])) spaced += ' ';
    spaced += name[i];
  }
  for (const std::string_view word : split(spaced, " _-.")) words.push_back(lower_case(word));
  return words;
}

/// Removes the first word that is in the table, and returns what stands beside it there.
template <std::size_t Size>
char take(Words& words, const std::pair<std::string_view, char> (&table)[Size]) {
  for (auto word = words.begin(); word != words.end(); ++word) {
    for (const auto& [known, meaning] : table) {
      if (*word != known) continue;
      words.erase(word);
      return meaning;
    }
  }
  return 0;
}

constexpr std::pair<std::string_view, char> sides[] = {
    {"left", 'L'}, {"right", 'R'}, {"l", 'L'}, {"r", 'R'}};
constexpr std::pair<std::string_view, char> ends[] = {
    {"fore", 'F'}, {"front", 'F'}, {"f", 'F'}, {"forelimb", 'F'}, {"foreleg", 'F'}, {"hind", 'H'},
    {"rear", 'H'}, {"back", 'H'},  {"h", 'H'}, {"hindlimb", 'H'}, {"hindleg", 'H'}};
constexpr std::pair<std::string_view, std::string_view> limbs[] = {
    {"lf", "LF"}, {"fl", "LF"}, {"rf", "RF"}, {"fr", "RF"},
    {"lh", "LH"}, {"hl", "LH"}, {"rh", "RH"}, {"hr", "RH"}};
constexpr std::pair<std::string_view, int> ranks[] = {
    {"scapula", 0},    {"withers", 0}, {"shoulder", 1}, {"hip", 1},     {"thigh", 2},
    {"thai", 2},       {"elbow", 3},   {"knee", 3},     {"stifle", 3},  {"wrist", 4},
    {"carpus", 4},     {"ankle", 4},   {"hock", 4},     {"tarsus", 4},  {"heel", 4},
    {"mcp", 5},        {"mtp", 5},     {"fetlock", 5},  {"pastern", 5}, {"metacarpus", 5},
    {"metatarsus", 5}, {"paw", 6},     {"foot", 6},     {"hand", 6},    {"hoof", 6},
    {"toe", 7},        {"toes", 7},    {"nail", 7},     {"tip", 7}};

}  // namespace

std::string limb_of_joint(std::string_view name) {
  Words words = words_of(name);
  for (const std::string& word : words) {
    const auto* found = std::find_if(std::begin(limbs), std::end(limbs),
                                     [&](const auto& limb) { return limb.first == word; });
    if (found != std::end(limbs)) return std::string(found->second);
  }
  const std::size_t count = words.size();
  Words rest = words;
  const char side = take(rest, sides), end = side ? take(rest, ends) : '\0';
  if (side && end) return {side, end};
  if (side || count < 2) return {};
  std::string first = words[0];
  std::transform(first.begin(), first.end(), first.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return first;
}

std::optional<int> rank_of_joint(std::string_view name) {
  for (const std::string& word : words_of(name)) {
    for (const auto& [known, rank] : ranks) {
      if (word == known) return rank;
    }
  }
  return std::nullopt;
}

}  // namespace wavecurve::io
