// Laying out text for a terminal: colour, columns, wrapping, numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "report/printable.h"

namespace rad::report {

enum class Ink : unsigned char { Plain, Bold, Dim, Red, Yellow, Cyan, Green };

/// Wraps text in terminal colour sequences where colour is on, else leaves it as it is.
class Paint {
 public:
  explicit Paint(bool on) : on_(on) {}
  [[nodiscard]] std::string operator()(Ink ink, std::string_view text) const;

 private:
  bool on_;
};

/// Columns that UTF-8 text takes, one for each code point.
std::size_t columns(std::string_view text);

/// Blanks added on the right up to `width` columns.
std::string padded(std::string_view text, std::size_t width);

/// Appends `text` in lines that are broken at blanks, of at most `width` columns with the `indent` blanks that each
/// begins with; a longer word stands alone.
void append_wrapped(std::string& out, std::string_view text, std::size_t indent, std::size_t width);

/// Six significant digits.
std::string short_number(double value);

/// "1 face", "2 faces", "12 345 faces"; the plural adds an s where none is given.
std::string counted(std::uint64_t count, std::string_view noun, std::string_view plural = {});

/// "1.5 MB"
std::string byte_size(std::uint64_t bytes);

}  // namespace rad::report
