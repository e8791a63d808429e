// What every patch mesh must hold, by brute force.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geom/predicates.h"
#include "mesh/face_frame.h"
#include "mesh/lengths.h"
#include "mesh/pmesh.h"
#include "tests/support/conforming_builder.h"

namespace rad::tests {

using Corner = std::uint32_t;

/// Corners of every patch as lattice points, with the face.
struct FlatPatches {
  std::vector<std::vector<Corner>> corners;
  std::vector<std::uint32_t> face;
};

inline FlatPatches flat_patches(const mesh::PatchMesh& patches) {
  FlatPatches flat;
  for (const auto face : patches.patches.faces()) {
    std::vector<Corner> corners;
    for (const auto vertex : face.vertices()) corners.push_back(patches.patches.data(vertex).lattice_point);
    flat.corners.push_back(corners);
    flat.face.push_back(patches.faces[patches.patches.data(face).face].origin);
  }
  return flat;
}

inline std::int64_t doubled_area(const std::vector<geom::PlanarPoint>& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum +=
        (ring[i].u - ring[0].u) * (ring[i + 1].v - ring[0].v) - (ring[i].v - ring[0].v) * (ring[i + 1].u - ring[0].u);
  }
  return sum;
}

/// Every patch strictly convex and counter-clockwise; patches cover each face but for the rounding of its outline.
inline void expect_exact_cover(const scene::ConformingModel& model, const mesh::PatchMesh& mesh) {
  const FlatPatches flat = flat_patches(mesh);
  std::vector<std::int64_t> covered(model.faces.size(), 0);
  for (std::size_t p = 0; p < flat.corners.size(); ++p) {
    ASSERT_LT(flat.face[p], model.faces.size());
    const mesh::FaceFrame frame(model, model.faces[flat.face[p]]);
    std::vector<geom::PlanarPoint> ring;
    for (const Corner corner : flat.corners[p]) ring.push_back(frame.flat(mesh.points[corner]));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      ASSERT_EQ(geom::orient2d(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]),
                geom::Sign::Positive);
    }
    covered[flat.face[p]] += doubled_area(ring);
  }
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const mesh::FaceFrame frame(model, model.faces[f]);
    std::int64_t expected = 0;
    double outline = 0;
    for (const scene::Loop& loop : model.loops_of(model.faces[f])) {
      std::vector<geom::PlanarPoint> ring;
      for (const auto id : model.corners_of(loop)) ring.push_back(frame.flat(model.points[id]));
      expected += doubled_area(ring);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
        outline += std::hypot(static_cast<double>(b.u - a.u), static_cast<double>(b.v - a.v));
      }
    }
    EXPECT_LE(std::abs(static_cast<double>(covered[f] - expected)), 2 * outline) << "face " << f;
  }
}

/// Per face: an edge has one use in each direction at most; those with one use are the divided loops, those of inner
/// edges have two; returns the number of edges with one use.
inline std::size_t expect_conforming_faces(const scene::ConformingModel& model, const mesh::PatchMesh& mesh) {
  const FlatPatches flat = flat_patches(mesh);
  std::vector<std::map<std::pair<Corner, Corner>, int>> uses(model.faces.size());
  for (std::size_t p = 0; p < flat.corners.size(); ++p) {
    const auto& c = flat.corners[p];
    for (std::size_t i = 0; i < c.size(); ++i) {
      const int count = ++uses[flat.face[p]][{c[i], c[(i + 1) % c.size()]}];
      EXPECT_EQ(count, 1);
    }
  }
  std::size_t single = 0;
  for (std::size_t f = 0; f < uses.size(); ++f) {
    for (const auto& [edge, count] : uses[f]) {
      if (uses[f].contains({edge.second, edge.first})) continue;
      ++single;
      bool on_loop = false;
      for (const scene::Loop& loop : model.loops_of(model.faces[f])) {
        const auto ring = model.corners_of(loop);
        for (std::size_t i = 0; i < ring.size() && !on_loop; ++i) {
          const auto &a = model.points[ring[i]], &b = model.points[ring[(i + 1) % ring.size()]];
          on_loop = geom::point_within_segment(mesh.points[edge.first], a, b, 1) &&
                    geom::point_within_segment(mesh.points[edge.second], a, b, 1);
        }
      }
      EXPECT_TRUE(on_loop) << "an edge with one use inside face " << f;
    }
  }
  return single;
}

/// No point within T of an edge that it does not belong to, and no two points within T.
inline void expect_no_t_vertices(const std::vector<geom::LatticePoint>& points,
                                 const std::set<std::pair<Corner, Corner>>& edges, std::int64_t tolerance) {
  std::set<Corner> used;
  for (const auto& edge : edges) used.insert({edge.first, edge.second});
  std::vector<Corner> by_x(used.begin(), used.end());
  const auto left_of = [&](Corner a, Corner b) { return points[a] < points[b]; };
  std::sort(by_x.begin(), by_x.end(), left_of);
  const auto reach = static_cast<std::int32_t>(tolerance);
  const auto first_from = [&](std::int32_t x) {
    return std::partition_point(by_x.begin(), by_x.end(), [&](Corner p) { return points[p].x < x; });
  };
  std::size_t shown = 0;
  for (const auto& [a, b] : edges) {
    const auto [low, high] = std::minmax(points[a].x, points[b].x);
    for (auto p = first_from(low - reach); p != by_x.end() && points[*p].x <= high + reach && shown < 5; ++p) {
      if (*p == a || *p == b) continue;
      const bool near = geom::point_within_segment(points[*p], points[a], points[b], tolerance);
      EXPECT_FALSE(near) << "point " << *p << " on edge " << a << "-" << b << ": " << ++shown;
    }
  }
  for (auto a = by_x.begin(); a != by_x.end(); ++a) {
    for (auto b = std::next(a); b != by_x.end() && points[*b].x - points[*a].x <= reach; ++b) {
      ASSERT_FALSE(geom::points_within(points[*a], points[*b], tolerance - 2)) << *a << " and " << *b;
    }
  }
}

inline std::set<std::pair<Corner, Corner>> edges_of(const mesh::PatchMesh& mesh) {
  std::set<std::pair<Corner, Corner>> edges;
  for (const auto& c : flat_patches(mesh).corners) {
    for (std::size_t i = 0; i < c.size(); ++i) edges.insert(std::minmax(c[i], c[(i + 1) % c.size()]));
  }
  return edges;
}

/// Longest edge in pitches.
inline double longest_edge(const mesh::PatchMesh& mesh) {
  std::int64_t longest = 0;
  for (const auto& [a, b] : edges_of(mesh)) {
    longest = std::max(longest, geom::squared_distance(mesh.points[a], mesh.points[b]));
  }
  return std::sqrt(static_cast<double>(longest));
}

inline mesh::PatchMesh meshed(const ConformingBuilder& builder, double longest,
                              mesh::PatchMethod method = mesh::PatchMethod::Grid) {
  mesh::PatchOptions options;
  options.longest_edge = longest;
  options.method = method;
  mesh::PatchOutcome outcome = mesh::pmesh(builder.model(), options);
  EXPECT_EQ(outcome.problem, "");
  return outcome.mesh ? std::move(*outcome.mesh) : mesh::PatchMesh{};
}

/// All of the above; `needle_tips` excuses edges longer than asked.
inline mesh::PatchMesh expect_sound(const ConformingBuilder& builder, double longest, bool needle_tips = false,
                                    mesh::PatchMethod method = mesh::PatchMethod::Grid) {
  mesh::PatchMesh mesh = meshed(builder, longest, method);
  expect_exact_cover(builder.model(), mesh);
  expect_conforming_faces(builder.model(), mesh);
  expect_no_t_vertices(mesh.points, edges_of(mesh), builder.model().tolerance.pitches);
  if (!needle_tips) {
    EXPECT_LE(longest_edge(mesh), longest * kUnit + 2 * mesh::kLengthRounding);
  }
  return mesh;
}

}  // namespace rad::tests
