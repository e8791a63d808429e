// The texture coordinates of a face as one affine map of space, and whether those of two faces are the same map.
#pragma once

#include <array>
#include <optional>

#include "scene/scene.h"

namespace rad::scene {

/// Two maps count as one where they differ by no more than this: half a texel of an image 4096 texels wide.
inline constexpr double kTextureTolerance = 0x1p-13;

/// Through the texture coordinates at three corners of a face, and constant along its normal.
class TextureMap {
 public:
  /// Nothing where the face has no texture coordinates or its corners lie on a line.
  static std::optional<TextureMap> of(const Scene& scene, const Face& face);

  /// Whether a face has, at all of its corners, what the map gives there: within kTextureTolerance, or moved over the
  /// surface by no more than `tolerance` (T, file units), as its vertices may be.
  [[nodiscard]] bool fits(const Scene& scene, const Face& face, double tolerance) const;

  /// Whether this map is the one to go on: its three corners span the larger triangle, ties by their places.
  [[nodiscard]] bool leads(const TextureMap& other) const;

 private:
  [[nodiscard]] dvec2 at(const dvec3& point) const { return value_ + dvec2(dot(u_, point), dot(v_, point)); }
  [[nodiscard]] double dot(const dvec3& gradient, const dvec3& point) const;
  void set_gradients(const std::array<dvec2, 3>& values);

  std::array<dvec3, 3> corner_;  ///< file units
  double doubled_area_ = 0;      ///< of their triangle
  dvec2 value_{0, 0};            ///< at the first of them
  dvec3 u_{0, 0, 0};             ///< gradients of both coordinates, 1 / file unit
  dvec3 v_{0, 0, 0};
};

/// Whether the texture coordinates of two faces are one affine map, that of the one that leads, so that merging the
/// faces loses nothing; also where neither has any.
bool same_texture_map(const Scene& scene, const Face& a, const Face& b, double tolerance);

}  // namespace rad::scene
