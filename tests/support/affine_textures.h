// Texture coordinates that are affine maps of space, so that every cut has one right answer.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/scene.h"
#include "tests/support/lattice_random.h"

namespace rad::tests {

/// Maps that are far from each other everywhere: a value tells which map it came from.
class AffineTextures {
 public:
  static constexpr std::uint32_t kMaps = 3;
  static constexpr double kApart = 1000;

  explicit AffineTextures(std::uint64_t seed) {
    LatticeRandom random(seed);
    for (auto& gradients : gradients_) {
      for (scene::dvec3& gradient : gradients) {
        for (int axis = 0; axis < 3; ++axis) gradient[axis] = static_cast<double>(random.between(-64, 64)) / 128;
      }
    }
  }

  [[nodiscard]] scene::dvec2 at(std::uint32_t map, const scene::dvec3& point) const {
    return {glm::dot(gradients_[map][0], point) + kApart * map, glm::dot(gradients_[map][1], point)};
  }
  [[nodiscard]] double steepest(std::uint32_t map) const {
    return std::max(glm::length(gradients_[map][0]), glm::length(gradients_[map][1]));
  }

  /// Gives every face one of the maps, by `map_of_face`.
  void put_on(scene::Scene& scene, const std::vector<std::uint32_t>& map_of_face) const {
    auto& values = scene.attributes.texture_coordinates;
    values.row_of_corner.assign(scene.corners.size(), scene::kNoRow);
    for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
      for (const scene::Loop& loop : scene.loops_of(scene.faces[id])) {
        for (std::uint32_t corner = loop.first; corner < loop.first + loop.count; ++corner) {
          values.row_of_corner[corner] = static_cast<scene::RowId>(values.table.size());
          values.table.push_back(at(map_of_face[id], scene.vertices[scene.corners[corner]]));
        }
      }
    }
  }

 private:
  std::array<std::array<scene::dvec3, 2>, kMaps> gradients_{};
};

}  // namespace rad::tests
