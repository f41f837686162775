#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace wavecurve::io {

/// What becomes of numbers with a point or an exponent: doubles, or texts as they are written, so
/// that no digit is lost.
enum class JsonNumbers { doubles, as_written };

inline constexpr int deepest_json = 100;
inline constexpr std::size_t largest_json = std::size_t{256} << 20;

/// The document of a JSON text; every reader of JSON uses this. Throws std::invalid_argument, with
/// the line and the column, for what is no JSON, for a number beyond the range of doubles, a key
/// that an object has twice, and lists and objects nested more than deepest_json deep: what copies
/// or writes a document later may do so by recursion.
nlohmann::json parse_json(const std::string& text, JsonNumbers numbers = JsonNumbers::doubles);
nlohmann::ordered_json parse_ordered_json(const std::string& text);

/// The same of a file of at most `bound` bytes; a larger one is refused. What is refused begins
/// with the file's name. Throws as read_file does.
nlohmann::json read_json(const std::filesystem::path& path,
                         JsonNumbers numbers = JsonNumbers::doubles,
                         std::size_t bound = largest_json);

}  // namespace wavecurve::io
