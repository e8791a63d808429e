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

// In the header, for nearly every pair of triangles is told apart here.
inline bool TriangleColumn::over_or_under(const std::array<dvec3, 3>& other, const SharedCorners& shared,
                                          double distance) const {
  bool over = true, under = true;
  for (int i = 0; i < 3; ++i) {
    if (shared[i] != kNotShared) continue;
    const double at = height(other[i]);
    over = over && at > distance;
    under = under && at < -distance;
  }
  return over || under;
}

inline bool TriangleColumn::beyond_edge(int edge, const std::array<dvec3, 3>& other, const SharedCorners& shared,
                                        double distance) const {
  const dvec3& inward = inward_[edge];
  for (int i = 0; i < 3; ++i) {
    const bool on_edge = shared[i] == edge || shared[i] == (edge + 1) % 3;
    if (on_edge) continue;
    // Written so that a triangle without area, whose planes are not numbers, proves nothing.
    if (!(inward.x * other[i].x + inward.y * other[i].y + inward.z * other[i].z - inward_offset_[edge] < -distance)) {
      return false;
    }
  }
  return true;
}

inline bool TriangleColumn::keeps_out(const std::array<dvec3, 3>& other, const SharedCorners& shared, double distance,
                                      bool beyond_edges_only) const {
  return (!beyond_edges_only && over_or_under(other, shared, distance)) || beyond_edge(0, other, shared, distance) ||
         beyond_edge(1, other, shared, distance) || beyond_edge(2, other, shared, distance);
}

}  // namespace rad::geom
