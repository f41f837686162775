#include "verification/prints/text_encoding.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace wavecurve::verification {

namespace {

/// Where the low byte of a unit of UTF-16 stands.
enum class ByteOrder { little_endian, big_endian };

bool take_mark(std::string_view& bytes, std::string_view mark) {
  if (!bytes.starts_with(mark)) return false;
  bytes.remove_prefix(mark.size());
  return true;
}

/// Without a mark: most characters of a table are ASCII, whose high byte is zero; no text in another
/// encoding has such bytes.
std::optional<ByteOrder> guess_byte_order(std::string_view bytes) {
  constexpr std::size_t enough = 4096;
  const std::string_view sample = bytes.substr(0, std::min(enough, bytes.size()));
  if (sample.size() < 2 || bytes.size() % 2 != 0) return std::nullopt;
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < sample.size(); ++i) zeros[i % 2] += sample[i] == '\0' ? 1 : 0;
  const std::size_t most = sample.size() / 4;
  if (zeros[0] == 0 && zeros[1] > most) return ByteOrder::little_endian;
  if (zeros[1] == 0 && zeros[0] > most) return ByteOrder::big_endian;
  return std::nullopt;
}

void append_utf8(std::string& text, std::uint32_t character) {
  const auto byte = [&text](std::uint32_t value) { text += static_cast<char>(value); };
  const auto continued = [&](std::uint32_t shift) { byte(0x80 | (character >> shift & 0x3F)); };
  if (character < 0x80) {
    byte(character);
  } else if (character < 0x800) {
    byte(0xC0 | character >> 6);
    continued(0);
  } else if (character < 0x10000) {
    byte(0xE0 | character >> 12);
    continued(6);
    continued(0);
  } else {
    byte(0xF0 | character >> 18);
    continued(12);
    continued(6);
    continued(0);
  }
}

/// The units of UTF-16 one by one.
class Utf16 {
 public:
  Utf16(std::string_view bytes, ByteOrder order) : bytes_(bytes), order_(order) {}

  std::string to_utf8() {
    std::string text;
    text.reserve(bytes_.size());
    while (place_ < bytes_.size()) append_utf8(text, next_character());
    return text;
  }

 private:
  std::uint32_t next_unit() {
    if (bytes_.size() - place_ < 2) refuse();
    const auto first = static_cast<unsigned char>(bytes_[place_]);
    const auto second = static_cast<unsigned char>(bytes_[place_ + 1]);
    place_ += 2;
    const bool little = order_ == ByteOrder::little_endian;
    return little ? first | std::uint32_t{second} << 8 : second | std::uint32_t{first} << 8;
  }

  std::uint32_t next_character() {
    const std::uint32_t unit = next_unit();
    if (unit < 0xD800 || unit > 0xDFFF) return unit;
    const std::uint32_t second = unit < 0xDC00 ? next_unit() : 0;
    if (second < 0xDC00 || second > 0xDFFF) refuse();
    return 0x10000 + ((unit - 0xD800) << 10) + (second - 0xDC00);
  }

  [[noreturn]] void refuse() const {
    throw std::invalid_argument(
        "the text is no whole UTF-16: it breaks off within the character at byte " +
        std::to_string(place_));
  }

  std::string_view bytes_;
  ByteOrder order_;
  std::size_t place_ = 0;
};

}  // namespace

std::string to_utf8(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) {
    throw std::invalid_argument("the text is UTF-32; UTF-8 and UTF-16 are read");
  }
  if (take_mark(bytes, "\xEF\xBB\xBF")) return std::string(bytes);
  if (take_mark(bytes, "\xFF\xFE")) return Utf16(bytes, ByteOrder::little_endian).to_utf8();
  if (take_mark(bytes, "\xFE\xFF")) return Utf16(bytes, ByteOrder::big_endian).to_utf8();
  if (const auto order = guess_byte_order(bytes)) return Utf16(bytes, *order).to_utf8();
  return std::string(bytes);
}

void for_each_text_line(std::string_view text,
                        const std::function<void(std::string_view line, int number)>& read) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    const std::size_t ending = text.substr(end).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(std::min(end + ending, text.size()));
    read(line, number);
  }
}

}  // namespace wavecurve::verification
