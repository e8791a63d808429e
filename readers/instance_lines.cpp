#include "readers/instance_lines.h"

#include "readers/text_cursor.h"

namespace rad::readers {

std::map<std::uint64_t, std::uint64_t> lines_of_instances(std::string_view text) {
  std::map<std::uint64_t, std::uint64_t> lines;
  TextCursor cursor(text);
  while (cursor.next_line()) {
    const std::string_view line = cursor.rest();
    if (!line.starts_with('#')) continue;
    const auto number = parse_integer(line.substr(1, line.find_first_of("= \t") - 1));
    if (number && *number > 0) lines.emplace(static_cast<std::uint64_t>(*number), cursor.line());
  }
  return lines;
}

}  // namespace rad::readers
