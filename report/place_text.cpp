#include "report/place_text.h"

#include <fmt/format.h>

#include <filesystem>

#include "report/printable.h"
#include "report/text_layout.h"
#include "report/units.h"

namespace rad::report {

std::string place_text(const scene::Where& where) {
  const std::string file = printable(where.file);
  if (where.line > 0) return fmt::format("{}:{}", file, where.line);
  if (!where.pointer.empty()) return fmt::format("{}#{}", file, printable(where.pointer));
  if (where.byte_offset) return fmt::format("{} byte {}", file, *where.byte_offset);
  return file;
}

std::string point_text(const scene::Where& where) {
  if (!where.point) return {};
  const geom::dvec3& point = *where.point;
  return fmt::format("({}, {}, {})", short_number(point.x), short_number(point.y), short_number(point.z));
}

std::string point_text(const scene::Where& where, const InputReport& input) {
  return where.point ? fmt::format("{} {}", point_text(where), unit_label(input.metres_per_unit)) : std::string();
}

std::string relative_path(std::string_view path, std::string_view root) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  if (root.empty() || !normal.is_absolute()) return normal.generic_string();
  const std::filesystem::path relative = normal.lexically_relative(root);
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return (inside ? relative : normal).generic_string();
}

}  // namespace rad::report
