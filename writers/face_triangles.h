// The one or two triangles of a face, for formats that hold nothing else.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace rad::writers {

/// Three indices into Scene::corners.
using Triangle = std::array<std::uint32_t, 3>;

struct FaceTriangles {
  std::array<Triangle, 2> triangles{};
  std::size_t count = 0;

  [[nodiscard]] auto begin() const { return triangles.begin(); }
  [[nodiscard]] auto end() const { return triangles.begin() + static_cast<std::ptrdiff_t>(count); }
};

/// A triangle as it is; a quad split along the diagonal that maximises the smallest angle, where that is a tie along
/// the one through the corner of lexicographically smallest position. Both halves have area and face the same way.
/// Nothing for a face with holes, with other than three or four corners, and where no diagonal gives such halves.
std::optional<FaceTriangles> triangles_of(const scene::Scene& scene, const scene::Face& face);

/// Says that a face is not one that triangles_of splits.
std::string unsplit_face(scene::FaceId id);

}  // namespace rad::writers
