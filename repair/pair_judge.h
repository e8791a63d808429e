// What the lint of the triangles asks of one pair.
#pragma once

#include <vector>

#include "repair/triangle_lint.h"

namespace rad::repair {

class PairJudge {
 public:
  PairJudge(const TriangleLint& lint, const TriangleSet& set)
      : lint_(lint), set_(set), width_(static_cast<double>(lint.tolerance_)) {}

  /// What is wrong with the triangle alone.
  void judge_alone(std::uint32_t triangle, std::vector<Evidence>& found) const;
  /// A cheap proof that nothing is wrong between two: by far the most pairs end here.
  [[nodiscard]] bool kept_apart(std::uint32_t a, std::uint32_t b) const;
  /// What is wrong between two that are not kept apart, in whichever order: all kinds but Contact.
  void judge(std::uint32_t x, std::uint32_t y, std::vector<Evidence>& found) const;
  /// Contact, and NearCoplanar where they overlap; not for two that are kept apart. True where they overlap, look
  /// opposite ways and are not one triangle, which is legal.
  bool judge_contact(std::uint32_t x, std::uint32_t y, std::vector<Evidence>& found) const;

 private:
  using Corners = std::array<LatticePoint, 3>;
  using Places = std::array<dvec3, 3>;

  [[nodiscard]] const Triangle& triangle(std::uint32_t i) const { return set_.triangles[i]; }
  [[nodiscard]] const geom::TriangleColumn& column(std::uint32_t i) const { return lint_.columns_[i]; }
  [[nodiscard]] const LatticePoint& point(PointId id) const { return set_.points[id]; }
  [[nodiscard]] dvec3 place(PointId id) const { return geom::as_vector(set_.points[id]); }
  [[nodiscard]] Corners corners(std::uint32_t i) const;
  [[nodiscard]] Places places(std::uint32_t i) const;

  [[nodiscard]] bool lies_on(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool opposite_contact(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool apart_by_construction(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] bool middle_on(std::uint32_t a, std::uint32_t b) const;
  void find_point_on_edge(std::uint32_t edge_of, std::uint32_t edge, PointId id, std::uint32_t point_of,
                          std::vector<Evidence>& found) const;
  void find_points_on_edges(std::uint32_t edges_of, std::uint32_t points_of, std::vector<Evidence>& found) const;

  const TriangleLint& lint_;
  const TriangleSet& set_;
  double width_;  ///< T, pitches
};

}  // namespace rad::repair
