// Isect: finds where edges of one plane meet the faces of another, and makes the common points, contact edges and
// chords part of both (paper 3.2).
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "repair/complex.h"
#include "repair/triangle_search.h"
#include "repair/triangulation.h"

namespace rad::repair {

/// A point this near a plane, as a share of T, is on it.
inline constexpr double kOnPlaneShare = 0.25;

class Isect {
 public:
  explicit Isect(Complex& complex) : complex_(complex), search_(complex) {}

  /// One pass over the edges that are new or have new triangles near. True where something changed. What was imprinted
  /// once is remembered and never imprinted again.
  bool pass(const Triangulation& triangulation);

 private:
  using ClusterPair = std::array<ClusterId, 2>;
  struct Pass;

  [[nodiscard]] std::vector<EdgeKey> edges_to_look_at(const Triangulation& triangulation);

  Complex& complex_;
  TriangleSearch search_;
  std::size_t edges_seen_ = 0;                       ///< of Complex::edges_added
  std::map<ClusterPair, std::set<PointId>> events_;  ///< of two planes: the points on both
  std::map<std::pair<EdgeKey, ClusterId>, PointId> crossing_;  ///< the vertex of an edge and a plane, made once
  std::set<std::pair<EdgeKey, ClusterId>> contacts_;
  std::set<std::pair<ClusterPair, EdgeKey>> chords_;
};

}  // namespace rad::repair
