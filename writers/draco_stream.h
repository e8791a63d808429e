// Triangles and what their vertices have, as a Draco stream that decodes to the same.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec.h"

namespace rad::writers {

enum class DracoUse : std::uint8_t { Position, Normal, Texture, Colour, Other };
enum class DracoNumber : std::uint8_t { Float, UnsignedShort };

/// One value for each vertex, packed without gaps.
struct DracoAttribute {
  DracoUse use = DracoUse::Other;
  DracoNumber number = DracoNumber::Float;
  std::uint8_t components = 3;
  bool normalized = false;
  std::string_view bytes;
};

/// With more, not every place of a grid is a float.
inline constexpr int kMostDracoBits = 24;

/// A grid on which all positions lie: origin + step · (0 … 2^bits − 1) along each axis.
struct DracoGrid {
  float origin[3];
  float step;
  int bits;  ///< 1 to kMostDracoBits
};

/// The grid of this step from `low` to `high`, which lie on it. Nothing where it would need more bits than floats have.
std::optional<DracoGrid> draco_grid(const geom::dvec3& low, const geom::dvec3& high, double step);

/// A number in the metadata of a stream.
struct DracoEntry {
  const char* name;
  double value;
};

struct DracoStream {
  std::string bytes;              ///< empty where Draco would not keep the triangles as they are
  std::vector<std::uint32_t> id;  ///< unique id of each attribute
  std::uint32_t vertices = 0;     ///< when decoded; attributes that differ at a place and fans that touch split them
  std::uint32_t triangles = 0;
};

/// `corners` index the vertices, three for each triangle; one attribute is of use Position, with three floats. Tries
/// the shortest encoding first; what does not decode to the same triangles, bit by bit, is encoded in another way.
DracoStream draco_stream(std::span<const DracoAttribute> attributes, std::span<const std::uint32_t> corners,
                         const std::optional<DracoGrid>& grid, std::span<const DracoEntry> entries = {});

}  // namespace rad::writers
