// Values at the corners of faces: texture coordinates and shading normals.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

namespace rad::scene {

using glm::dvec2;

/// Row of a table of corner values; kNoRow where a corner has none.
using RowId = std::uint32_t;
inline constexpr RowId kNoRow = std::numeric_limits<RowId>::max();

/// A table of values and, for each corner, its row. A face has values at all of its corners or at none. Both vectors
/// are empty where no face has any, so that scenes without values pay nothing.
template <typename Value>
struct CornerValues {
  std::vector<Value> table;          ///< finite
  std::vector<RowId> row_of_corner;  ///< same indexing as Scene::corners

  [[nodiscard]] bool empty() const { return row_of_corner.empty(); }
  [[nodiscard]] RowId row(std::size_t corner) const { return empty() ? kNoRow : row_of_corner[corner]; }
};

/// Where the texture coordinates (0,0) lie in an image: at its lower left (OBJ, PLY) or upper left corner (glTF).
enum class TextureOrigin : std::uint8_t { LowerLeft, UpperLeft };

/// What faces have at their corners beside a position.
struct CornerAttributes {
  CornerValues<dvec2> texture_coordinates;
  TextureOrigin texture_origin = TextureOrigin::LowerLeft;
  CornerValues<glm::dvec3> normals;  ///< to the front, as read; of about unit length in a sound file

  [[nodiscard]] bool empty() const { return texture_coordinates.empty() && normals.empty(); }
};

}  // namespace rad::scene
