// Isect: finds where edges of one plane meet the faces of another, and makes the common points, contact edges and
// chords part of both (paper 3.2).
#pragma once

#include <tsl/robin_map.h>
#include <tsl/robin_set.h>

#include <array>
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
  /// Two clusters, the smaller id in the high half.
  using ClusterPair = std::uint64_t;
  /// A point on the planes of both.
  using Event = std::pair<ClusterPair, PointId>;
  using EdgeAndCluster = std::pair<EdgeKey, ClusterId>;
  struct Pass;
  struct PairHash {
    template <typename Second>
    std::size_t operator()(const std::pair<std::uint64_t, Second>& key) const {
      return EdgeKeyHash()(key.first ^ (std::uint64_t{key.second} * 0xbf58476d1ce4e5b9u));
    }
  };

  [[nodiscard]] std::vector<EdgeKey> edges_to_look_at(const Triangulation& triangulation);

  Complex& complex_;
  TriangleSearch search_;
  std::size_t edges_seen_ = 0;                                  ///< of Complex::edges_added
  std::vector<Event> events_;                                   ///< ascending
  tsl::robin_map<EdgeAndCluster, PointId, PairHash> crossing_;  ///< the vertex of an edge and a plane, made once
  tsl::robin_set<EdgeAndCluster, PairHash> contacts_;
  tsl::robin_set<std::pair<ClusterPair, EdgeKey>, PairHash> chords_;
};

}  // namespace rad::repair
