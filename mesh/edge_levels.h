// How often the edges of patches may be halved: a property of the edge, whichever surfaces it belongs to.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>

#include "geom/vec.h"

namespace rad::mesh {

class EdgeLevels {
 public:
  /// The edge between two points may be halved `levels` times; of several answers the least holds.
  void allow(std::uint32_t a, std::uint32_t b, std::uint32_t levels);

  /// Where edges leave a common point at a small angle, no half comes to lie nearer than `spacing` (pitches) to another
  /// of them: faces of both need have nothing in common but that point.
  void keep_apart(std::span<const geom::LatticePoint> points, double spacing);

  /// Of an edge that was named in allow().
  [[nodiscard]] std::uint32_t of(std::uint32_t a, std::uint32_t b) const { return levels_.at(key(a, b)); }

 private:
  using Key = std::array<std::uint32_t, 2>;
  static Key key(std::uint32_t a, std::uint32_t b) { return a < b ? Key{a, b} : Key{b, a}; }

  std::map<Key, std::uint32_t> levels_;
};

}  // namespace rad::mesh
