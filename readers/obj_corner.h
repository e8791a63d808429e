// The corners of an OBJ face: "7", "7/1", "7//3" or "7/1/3".
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/corner_values.h"

namespace rad::readers {

/// Indices as the file states them: from 1, or negative from the last; 0 for a part that is absent or no number.
struct ObjCorner {
  std::int64_t vertex = 0;
  std::int64_t texture = 0;
  std::int64_t normal = 0;
};

/// Nothing where the token is not a corner. The parts after the vertex only have to look like indices.
std::optional<ObjCorner> obj_corner(std::string_view token);

/// A row that cannot exist: a face that names it is left without the values.
inline constexpr scene::RowId kNoObjRow = scene::kNoRow - 1;

/// The row that an index names in a table that holds `count` rows so far; later rows may be named too. scene::kNoRow
/// for index 0, kNoObjRow for a row before the first.
scene::RowId obj_row(std::int64_t index, std::size_t count);

/// Corners of one face, or of several in a row. The three vectors are of one length.
struct ObjCorners {
  std::vector<std::uint64_t> vertices;  ///< 0-based; may not be read yet
  std::vector<scene::RowId> texture_rows;
  std::vector<scene::RowId> normal_rows;

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
  void clear();
  void append(const ObjCorners& other);
};

/// Whether a corner names a row.
bool names_rows(std::span<const scene::RowId> rows);

}  // namespace rad::readers
