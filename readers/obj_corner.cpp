#include "readers/obj_corner.h"

#include <algorithm>

#include "readers/text_cursor.h"

namespace rad::readers {
namespace {

// So many digits fit 64 bits.
constexpr std::size_t kPlainDigits = 18;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool may_stand_in_tail(char c) { return is_digit(c) || c == '/' || c == '-' || c == '+'; }

// Nearly every index is a few plain digits: read here, at a fraction of the general price. Nothing where the text
// starts otherwise.
std::optional<std::int64_t> take_plain_index(std::string_view& text) {
  std::int64_t index = 0;
  std::size_t length = 0;
  for (; length < text.size() && length < kPlainDigits && is_digit(text[length]); ++length) {
    index = index * 10 + (text[length] - '0');
  }
  if (length == 0 || (length < text.size() && text[length] != '/')) return std::nullopt;
  text.remove_prefix(length);
  return index;
}

std::optional<std::int64_t> take_index(std::string_view& text) {
  if (const auto plain = take_plain_index(text)) return plain;
  const std::size_t length = std::min(text.find('/'), text.size());
  const auto index = parse_integer(text.substr(0, length));
  text.remove_prefix(length);
  return index;
}

// The index after a slash; the text then starts with the next slash.
std::int64_t take_further_index(std::string_view& text) {
  if (text.empty()) return 0;
  text.remove_prefix(1);
  return take_index(text).value_or(0);
}

}  // namespace

std::optional<ObjCorner> obj_corner(std::string_view token) {
  const auto vertex = take_index(token);
  if (!vertex || !std::ranges::all_of(token, may_stand_in_tail)) return std::nullopt;
  ObjCorner corner;
  corner.vertex = *vertex;
  corner.texture = take_further_index(token);
  corner.normal = take_further_index(token);
  return corner;
}

scene::RowId obj_row(std::int64_t index, std::size_t count) {
  if (index == 0) return scene::kNoRow;
  const std::int64_t row = index > 0 ? index - 1 : static_cast<std::int64_t>(count) + index;
  return row < 0 || row >= std::int64_t{kNoObjRow} ? kNoObjRow : static_cast<scene::RowId>(row);
}

void ObjCorners::clear() {
  vertices.clear();
  texture_rows.clear();
  normal_rows.clear();
}

void ObjCorners::append(const ObjCorners& other) {
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  texture_rows.insert(texture_rows.end(), other.texture_rows.begin(), other.texture_rows.end());
  normal_rows.insert(normal_rows.end(), other.normal_rows.begin(), other.normal_rows.end());
}

bool names_rows(std::span<const scene::RowId> rows) {
  return std::ranges::any_of(rows, [](scene::RowId row) { return row != scene::kNoRow; });
}

}  // namespace rad::readers
