#include "readers/recorded_comment.h"

#include <cmath>

#include "readers/text_cursor.h"

namespace rad::readers {
namespace {

// Whether the next token is `key` with a finite number behind it.
bool read_keyed(TextCursor& cursor, std::string_view key, double& value) {
  const std::string_view token = cursor.next_token();
  if (!token.starts_with(key)) return false;
  const auto number = parse_number(token.substr(key.size()));
  value = number.value_or(0);
  return number && std::isfinite(value);
}

}  // namespace

std::optional<scene::RecordedLattice> record_of_comment(std::string_view comment) {
  const std::size_t start = comment.find_first_not_of("# \t");
  if (start == std::string_view::npos || !comment.substr(start).starts_with("radfix T=")) return std::nullopt;
  TextCursor cursor(comment.substr(start));
  cursor.next_line();
  cursor.next_token();
  scene::RecordedLattice record;
  geom::dvec3& origin = record.lattice.origin;
  const bool sound = read_keyed(cursor, "T=", record.tolerance) && read_keyed(cursor, "h=", record.lattice.pitch) &&
                     read_keyed(cursor, "origin=", origin.x) && read_keyed(cursor, "", origin.y) &&
                     read_keyed(cursor, "", origin.z) && cursor.next_token().empty();
  if (!sound) return std::nullopt;
  return record;
}

}  // namespace rad::readers
