// A cheap proof that two triangles keep apart: one of four planes along a triangle has the other one on its far side.
#pragma once

#include <array>

#include "geom/vec.h"

namespace rad::geom {

/// Per corner of another triangle: the corner of this one that it is, or kNotShared.
using SharedCorners = std::array<std::int8_t, 3>;
inline constexpr std::int8_t kNotShared = -1;

/// The plane of a triangle and, at right angles to it, a plane along each edge. Rounded: coordinates are below 2^24 and
/// unit normals have an error of some 2^-52, so distances have one below 1e-7 pitches.
class TriangleColumn {
 public:
  TriangleColumn() = default;
  /// Of a triangle without area nothing keeps out.
  explicit TriangleColumn(const std::array<LatticePoint, 3>& corners);

  [[nodiscard]] const dvec3& normal() const { return normal_; }
  /// Signed distance from the triangle's plane, pitches.
  [[nodiscard]] double height(const dvec3& place) const {
    return normal_.x * place.x + normal_.y * place.y + normal_.z * place.z - offset_;
  }
  /// Whether every corner of `other` that is not shared lies more than `distance` pitches beyond one of the planes, and
  /// the shared ones lie in that plane. Then the two meet in what they share and nowhere else, and those corners are
  /// farther than `distance` from this triangle. The triangle's own plane does not count where `beyond_edges_only`:
  /// a flap that rises from a common edge at a small angle lies over this triangle all the same. Not all three corners
  /// may be shared.
  [[nodiscard]] bool keeps_out(const std::array<dvec3, 3>& other, const SharedCorners& shared, double distance,
                               bool beyond_edges_only) const;

 private:
  [[nodiscard]] bool over_or_under(const std::array<dvec3, 3>& other, const SharedCorners& shared,
                                   double distance) const;
  [[nodiscard]] bool beyond_edge(int edge, const std::array<dvec3, 3>& other, const SharedCorners& shared,
                                 double distance) const;

  dvec3 normal_{0, 0, 0};
  double offset_ = 0;
  std::array<dvec3, 3> inward_{};  ///< per edge, from corner i to corner i+1
  std::array<double, 3> inward_offset_{};
};

}  // namespace rad::geom
