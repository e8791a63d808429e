// The plane map of one cluster: its constrained Delaunay triangulation and the pieces that cover each triangle.
#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <vector>

#include "geom/planar_mesh.h"
#include "repair/complex.h"
#include "repair/triangulation.h"

namespace rad::repair {

class ClusterMap {
 public:
  ClusterMap(const Complex& complex, ClusterId cluster);

  [[nodiscard]] const std::vector<geom::PlanarTriangle>& triangles() const { return mesh_.triangles; }
  [[nodiscard]] std::array<PointId, 3> points(std::size_t triangle) const;
  /// Index into covers().
  [[nodiscard]] std::uint32_t cover(std::size_t triangle) const { return cover_[triangle]; }
  /// Sets of pieces, ascending; the first is empty.
  [[nodiscard]] const std::vector<std::vector<PieceId>>& covers() const { return covers_; }
  [[nodiscard]] const Stacking& stacking() const { return stacking_; }

  /// Flips diagonals that have the apex of one of their triangles within `tolerance` where the other diagonal is
  /// farther from its own.
  void flip_slivers(double tolerance);

 private:
  void gather();
  void note_conflicts();
  void spread_covers();
  [[nodiscard]] std::uint32_t crossed(std::uint32_t cover, std::uint32_t triangle, int edge);
  [[nodiscard]] std::uint32_t toggled(std::uint32_t cover, PieceId piece);
  [[nodiscard]] std::uint32_t number_of(std::vector<PieceId> set);
  bool flip_if_better(std::uint32_t triangle, int edge, double tolerance);
  [[nodiscard]] double clearance(std::uint32_t a, std::uint32_t b, std::uint32_t p, std::uint32_t q) const;

  const Complex& complex_;
  ClusterId cluster_;
  std::vector<PointId> ids_;
  std::vector<geom::PlanarPoint> flat_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  geom::PlanarMesh mesh_;
  std::vector<std::uint32_t> cover_;
  std::vector<std::vector<PieceId>> covers_{{}};
  struct SetHash {
    std::size_t operator()(const std::vector<PieceId>& set) const {
      std::uint64_t hash = set.size();
      for (const PieceId id : set) hash = EdgeKeyHash()(hash ^ id);
      return static_cast<std::size_t>(hash);
    }
  };
  tsl::robin_map<std::vector<PieceId>, std::uint32_t, SetHash> cover_ids_;
  tsl::robin_map<std::uint64_t, std::uint32_t, EdgeKeyHash> toggled_;  ///< cover and piece: the cover beyond
  Stacking stacking_;
};

}  // namespace rad::repair
