#include "wavecurve/io/files/detail/for_each_line.hpp"

#include <algorithm>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

void for_each_line(std::string_view text,
                   const std::function<void(std::string_view line, int number)>& read) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::string_view content = trimmed(line.substr(0, line.find('#')));
    if (!content.empty()) read(content, number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace wavecurve::io
