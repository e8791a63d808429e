// A face as triangles between its corners: where a point lies among them.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace rad::scene {

/// Index into Scene::corners.
using CornerId = std::uint32_t;

/// A value at a place on a face is Σ share[i] · value(corner[i]); the shares are 0..1 and add up to 1.
struct FacePlace {
  std::array<CornerId, 3> corner{};
  std::array<double, 3> share{1, 0, 0};
};

/// What is given at the corners of a face goes on affinely over each of its triangles. A triangle is its own; of other
/// faces they are the constrained Delaunay triangles between the rings on the lattice, of faces whose rings cross a
/// fan. The order in which a file lists the corners does not matter.
class FaceMap {
 public:
  FaceMap(const Scene& scene, const Face& face, const geom::Lattice& lattice);

  /// The place on the face nearest to a point, which is given in file units.
  [[nodiscard]] FacePlace nearest(const dvec3& point) const;

  /// Twice the area of the outer loop times the unit normal, pitches².
  [[nodiscard]] const dvec3& normal() const { return normal_; }

 private:
  struct Triangle {
    std::array<CornerId, 3> corner{};
    std::array<dvec3, 3> place;
    dvec3 low;  ///< corners of its box
    dvec3 high;
  };

  void add_fan(const Scene& scene, const Loop& outer);
  void add_triangle(const Scene& scene, std::array<CornerId, 3> corners);

  dvec3 normal_{0, 0, 0};
  std::vector<Triangle> triangles_;
};

}  // namespace rad::scene
