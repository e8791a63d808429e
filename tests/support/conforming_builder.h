// Conforming models made by hand, face by face, on a lattice of pitch 2^-10 with T = 32 pitches.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "geom/constrained_triangulation.h"
#include "scene/conforming_model.h"
#include "tests/support/lattice_random.h"

namespace rad::tests {

using geom::LatticePoint;
using Ring3 = std::vector<LatticePoint>;

inline constexpr std::int32_t kUnit = 1024;  ///< pitches in a file unit
inline constexpr std::int64_t kBuilderTolerance = 32;

/// A point given in file units.
inline LatticePoint at(double x, double y, double z = 0) {
  return {static_cast<std::int32_t>(std::lround(x * kUnit)), static_cast<std::int32_t>(std::lround(y * kUnit)),
          static_cast<std::int32_t>(std::lround(z * kUnit))};
}

class ConformingBuilder {
 public:
  ConformingBuilder() {
    model_.lattice.pitch = 1.0 / kUnit;
    model_.tolerance.pitches = kBuilderTolerance;
    model_.tolerance.length = static_cast<double>(kBuilderTolerance) / kUnit;
  }

  void use_material(scene::MaterialId id) { material_ = id; }
  void use_object(scene::ObjectId id) { object_ = id; }

  /// Adds a face: the outer loop counter-clockwise from the front, holes clockwise, edges inside it, single points.
  void add_face(const Ring3& outer, const std::vector<Ring3>& holes = {},
                const std::vector<std::array<LatticePoint, 2>>& inner = {}, const Ring3& single = {}) {
    scene::ConformingFace face;
    face.first_loop = static_cast<std::uint32_t>(model_.loops.size());
    face.loop_count = static_cast<std::uint32_t>(1 + holes.size());
    face.first_inner_edge = static_cast<std::uint32_t>(model_.inner_edges.size());
    face.inner_edge_count = static_cast<std::uint32_t>(inner.size());
    face.first_triangle = static_cast<std::uint32_t>(model_.triangles.size());
    face.material = material_;
    face.object = object_;
    face.source = static_cast<scene::FaceId>(model_.faces.size());
    std::set<scene::PointId> used;
    std::vector<std::array<scene::PointId, 2>> outline;
    add_loop(outer, used, outline);
    for (const Ring3& hole : holes) add_loop(hole, used, outline);
    for (const auto& edge : inner) {
      model_.inner_edges.push_back({point(edge[0]), point(edge[1])});
      used.insert(model_.inner_edges.back().begin(), model_.inner_edges.back().end());
    }
    for (const LatticePoint& p : single) used.insert(point(p));
    const std::span inner_ids(model_.inner_edges.begin() + face.first_inner_edge, model_.inner_edges.end());
    triangulate(outer, {used.begin(), used.end()}, outline, {inner_ids.begin(), inner_ids.end()});
    face.triangle_count = static_cast<std::uint32_t>(model_.triangles.size()) - face.first_triangle;
    model_.faces.push_back(face);
  }

  /// Axis-parallel closed box, faces outward.
  void add_box(const LatticePoint& low, const LatticePoint& high, bool inward = false) {
    const auto corner = [&](unsigned bits) {
      return LatticePoint{bits & 1U ? high.x : low.x, bits & 2U ? high.y : low.y, bits & 4U ? high.z : low.z};
    };
    constexpr std::array<std::array<unsigned, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& side : kSides) {
      Ring3 ring;
      for (const unsigned bits : side) ring.push_back(corner(bits));
      if (inward) std::reverse(ring.begin(), ring.end());
      add_face(ring);
    }
  }

  [[nodiscard]] const scene::ConformingModel& model() const { return model_; }

 private:
  scene::PointId point(const LatticePoint& p) {
    const auto [entry, added] = ids_.try_emplace(p, static_cast<scene::PointId>(model_.points.size()));
    if (added) model_.points.push_back(p);
    return entry->second;
  }

  void add_loop(const Ring3& ring, std::set<scene::PointId>& used,
                std::vector<std::array<scene::PointId, 2>>& outline) {
    model_.loops.push_back(
        {static_cast<std::uint32_t>(model_.corners.size()), static_cast<std::uint32_t>(ring.size())});
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const scene::PointId from = point(ring[i]);
      model_.corners.push_back(from);
      used.insert(from);
      outline.push_back({from, point(ring[(i + 1) % ring.size()])});
    }
  }

  void triangulate(const Ring3& outer, const std::vector<scene::PointId>& used,
                   std::vector<std::array<scene::PointId, 2>> outline,
                   std::vector<std::array<scene::PointId, 2>> inner) {
    geom::IntVector normal;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const auto n =
          geom::cross(geom::difference(outer[i], outer[0]), geom::difference(outer[(i + 1) % outer.size()], outer[0]));
      normal = {normal.x + n.x, normal.y + n.y, normal.z + n.z};
    }
    const int dropped = geom::dominant_axis(normal);
    const std::array<std::int64_t, 3> components{normal.x, normal.y, normal.z};
    std::vector<geom::PlanarPoint> flat;
    std::map<scene::PointId, std::uint32_t> index;
    for (const scene::PointId id : used) {
      index[id] = static_cast<std::uint32_t>(flat.size());
      flat.push_back(geom::project(model_.points[id], dropped));
    }
    for (auto* edges : {&outline, &inner}) {
      for (auto& edge : *edges) edge = {index[edge[0]], index[edge[1]]};
    }
    for (const auto& triangle : geom::triangulate_region(flat, outline, inner)) {
      auto [a, b, c] = triangle.corners;
      if (components[static_cast<std::size_t>(dropped)] < 0) std::swap(b, c);
      model_.triangles.push_back({used[a], used[b], used[c]});
    }
  }

  scene::ConformingModel model_;
  std::map<LatticePoint, scene::PointId> ids_;
  scene::MaterialId material_ = 0;
  scene::ObjectId object_ = 0;
};

inline Ring3 rectangle(double x0, double y0, double x1, double y1, double z = 0) {
  return {at(x0, y0, z), at(x1, y0, z), at(x1, y1, z), at(x0, y1, z)};
}

inline Ring3 reversed(Ring3 ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

inline Ring3 circle(double x, double y, double radius, int corners) {
  Ring3 ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
  }
  return ring;
}

/// The ring carried into a plane that no axis is parallel to: (x, y) to x·(2,2,1)/3 + y·(-2,1,2)/3, rounded.
inline Ring3 tilted(const Ring3& ring) {
  Ring3 result;
  for (const LatticePoint& p : ring) {
    const double x = p.x, y = p.y;
    result.push_back({static_cast<std::int32_t>(std::lround((2 * x - 2 * y) / 3)),
                      static_cast<std::int32_t>(std::lround((2 * x + y) / 3)),
                      static_cast<std::int32_t>(std::lround((x + 2 * y) / 3))});
  }
  return result;
}

}  // namespace rad::tests
