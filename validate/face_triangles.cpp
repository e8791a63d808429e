#include "validate/face_triangles.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

#include "geom/constrained_triangulation.h"
#include "validate/rings.h"

namespace rad::validate {
namespace {

using geom::Int128;
using geom::LatticePoint;
using geom::PlanarPoint;
using geom::Sign;
using scene::Face;
using scene::LatticeModel;
using scene::Loop;
using scene::Scene;

constexpr std::size_t kFacesPerBlock = 4096;
// Beyond this the quadratic test is left to the triangulation, which finds crossings too. Below it the test comes first
// because a bow tie has no area and would count as degenerate.
constexpr std::size_t kCrossingTestCorners = 4096;
// Beyond this the quadratic search for a fan is left out.
constexpr std::size_t kMostFanCorners = 256;

struct Block {
  std::vector<FaceTriangle> triangles;
  std::vector<std::array<bool, 3>> boundaries;
};

/// One face flattened: distinct points in ascending order and rings of indices into them, repeats removed.
struct FlatFace {
  std::vector<PointId> ids;
  std::vector<PlanarPoint> points;
  std::vector<Ring> rings;
};

class FaceTriangulator {
 public:
  FaceTriangulator(const Scene& scene, const LatticeModel& model, const geom::Tolerance& tolerance,
                   FaceTriangles& result)
      : scene_(scene),
        model_(model),
        tolerance_(static_cast<double>(tolerance.pitches)),
        tolerance_pitches_(tolerance.pitches),
        result_(result) {}

  void triangulate(FaceId id, Block& block) {
    const Face& face = scene_.faces[id];
    if (model_.left_out[id]) {
      result_.condition[id] = FaceCondition::LeftOut;
      return;
    }
    if (face.loop_count == 1 && scene_.loops[face.first_loop].count == 3) return triangle(id, face, block);
    polygon(id, face, block);
  }

 private:
  void triangle(FaceId id, const Face& face, Block& block) {
    const auto c = model_.corners_of(scene_.loops[face.first_loop]);
    const std::array<LatticePoint, 3> p{model_.points[c[0]], model_.points[c[1]], model_.points[c[2]]};
    const geom::IntVector n = geom::cross(geom::difference(p[1], p[0]), geom::difference(p[2], p[0]));
    result_.normal[id] = {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
    for (int i = 0; i < 3; ++i) {
      if (collapses(p[i], p[(i + 1) % 3], p[(i + 2) % 3])) {
        result_.condition[id] = FaceCondition::Degenerate;
        return;
      }
    }
    emit(id, {c[0], c[1], c[2]}, {true, true, true}, block);
  }

  // A corner within T of another, or of the inside of the opposite edge. Near an end of the edge a corner that is more
  // than T from the end may come nearer: points that are kept apart by the weld distance w = 1.16 T still leave a
  // height of √(w² - T²) = 0.58 T.
  [[nodiscard]] bool collapses(const LatticePoint& corner, const LatticePoint& from, const LatticePoint& to) const {
    if (geom::points_within(corner, from, tolerance_pitches_)) return true;
    if (!geom::point_within_segment(corner, from, to, tolerance_pitches_)) return false;
    return geom::foot_inside_segment(corner, from, to, tolerance_pitches_) ||
           geom::point_within_segment(corner, from, to, tolerance_pitches_ / 2);
  }

  void polygon(FaceId id, const Face& face, Block& block) {
    result_.normal[id] = newell_normal(scene_, model_, face);
    const FlatFace flat = flatten(id, face);
    if (flat.ids.size() < 3) {
      result_.condition[id] = FaceCondition::Degenerate;
      return;
    }
    const bool convex = flat.rings.size() == 1 && is_convex(flat.points, flat.rings[0], false);
    if (!convex && flat.ids.size() <= kCrossingTestCorners && edges_cross(flat.points, flat.rings)) {
      result_.condition[id] = FaceCondition::RingCrosses;
      return;
    }
    if (is_thin(id, flat)) {
      result_.condition[id] = FaceCondition::Degenerate;
      return;
    }
    if (convex && is_convex(flat.points, flat.rings[0], true)) return fan(id, flat, 0, block);
    const std::optional<std::size_t> start = is_warped(id, flat) ? fan_start(id, flat) : std::nullopt;
    return start ? fan(id, flat, *start, block) : constrained(id, flat, block);
  }

  // Off its plane by more than T: which triangles it is made of is then a matter of what is meant.
  [[nodiscard]] bool is_warped(FaceId id, const FlatFace& flat) const {
    geom::dvec3 middle(0, 0, 0);
    for (const PointId p : flat.ids) middle += vector_of(p) / static_cast<double>(flat.ids.size());
    const geom::dvec3 normal = glm::normalize(result_.normal[id]);
    return std::ranges::any_of(
        flat.ids, [&](PointId p) { return std::abs(glm::dot(vector_of(p) - middle, normal)) > tolerance_; });
  }

  // What draws polygons draws them as fans. Where in the ring the corner is, first in space, from which a fan covers
  // the face without folding; nothing where there is none, or holes.
  [[nodiscard]] std::optional<std::size_t> fan_start(FaceId id, const FlatFace& flat) const {
    if (flat.rings.size() != 1 || flat.ids.size() > kMostFanCorners) return std::nullopt;
    const Ring& ring = flat.rings[0];
    const Sign wanted = faces_backwards(result_.normal[id]) ? Sign::Negative : Sign::Positive;
    std::vector<std::size_t> starts(ring.size());
    std::iota(starts.begin(), starts.end(), std::size_t{0});
    std::ranges::sort(starts, {}, [&](std::size_t at) { return ring[at]; });
    const auto covers = [&](std::size_t start) {
      const auto corner = [&](std::size_t i) { return flat.points[ring[(start + i) % ring.size()]]; };
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        if (geom::orient2d(corner(0), corner(i), corner(i + 1)) != wanted) return false;
      }
      return true;
    };
    const auto found = std::ranges::find_if(starts, covers);
    return found == starts.end() ? std::nullopt : std::optional(*found);
  }

  // Twice the area at most T times the extent: nowhere much thicker than T. For a triangle exactly: a height of at
  // most T, which is what vertex-edge separation rules out in a repaired model.
  bool is_thin(FaceId id, const FlatFace& flat) const {
    geom::Box box;
    for (const PointId p : flat.ids) box.add(vector_of(p));
    double extent = box.diagonal();
    constexpr std::size_t kPairwise = 64;
    if (flat.ids.size() <= kPairwise) {
      extent = 0;
      for (std::size_t i = 0; i < flat.ids.size(); ++i) {
        for (std::size_t j = i + 1; j < flat.ids.size(); ++j) {
          extent = std::max(extent, glm::distance(vector_of(flat.ids[i]), vector_of(flat.ids[j])));
        }
      }
    }
    return glm::length(result_.normal[id]) <= tolerance_ * extent;
  }

  geom::dvec3 vector_of(PointId id) const {
    const LatticePoint& p = model_.points[id];
    return {p.x, p.y, p.z};
  }

  // Of several flaws the gravest stays, whichever corner the ring is walked from.
  void note_flaw(FaceId id, RingFlaw flaw) { result_.flaw[id] = std::max(result_.flaw[id], flaw); }

  FlatFace flatten(FaceId id, const Face& face) {
    FlatFace flat;
    const int dropped = projection_axis(result_.normal[id]);
    for (const Loop& loop : scene_.loops_of(face)) {
      const auto corners = model_.corners_of(loop);
      flat.ids.insert(flat.ids.end(), corners.begin(), corners.end());
    }
    std::sort(flat.ids.begin(), flat.ids.end());
    flat.ids.erase(std::unique(flat.ids.begin(), flat.ids.end()), flat.ids.end());
    for (const PointId p : flat.ids) flat.points.push_back(geom::project(model_.points[p], dropped));
    for (const Loop& loop : scene_.loops_of(face)) {
      Ring ring = ring_of(id, flat, model_.corners_of(loop));
      if (ring.size() >= 3) flat.rings.push_back(std::move(ring));
    }
    if (flat.rings.empty()) flat.ids.clear();
    check_holes(id, flat);
    return flat;
  }

  // Indices into flat.ids without repeats in a row and without spikes, from the smallest on: the same ring whichever
  // corner the file starts with.
  Ring ring_of(FaceId id, const FlatFace& flat, std::span<const PointId> corners) {
    Ring ring;
    for (const PointId p : corners) {
      const auto index =
          static_cast<std::uint32_t>(std::lower_bound(flat.ids.begin(), flat.ids.end(), p) - flat.ids.begin());
      if (!ring.empty() && ring.back() == index) {
        note_flaw(id, RingFlaw::RepeatedPoint);
      } else if (ring.size() >= 2 && ring[ring.size() - 2] == index) {
        note_flaw(id, RingFlaw::Spike);
        ring.pop_back();
      } else {
        ring.push_back(index);
      }
    }
    close_ring(id, ring);
    if (ring.size() >= 3) std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  void close_ring(FaceId id, Ring& ring) {
    while (ring.size() >= 2) {
      const std::size_t n = ring.size();
      if (ring.front() == ring.back()) {
        note_flaw(id, RingFlaw::RepeatedPoint);
        ring.pop_back();
      } else if (n >= 3 && ring[n - 2] == ring[0]) {
        note_flaw(id, RingFlaw::Spike);
        ring.resize(n - 2);
      } else if (n >= 3 && ring[n - 1] == ring[1]) {
        note_flaw(id, RingFlaw::Spike);
        ring.erase(ring.begin(), ring.begin() + 2);
      } else {
        return;
      }
    }
  }

  void check_holes(FaceId id, const FlatFace& flat) {
    for (std::size_t hole = 1; hole < flat.rings.size(); ++hole) {
      for (const std::uint32_t corner : flat.rings[hole]) {
        if (!inside_or_on(flat.points, flat.rings[0], flat.points[corner])) note_flaw(id, RingFlaw::HoleOutside);
      }
    }
  }

  // Axis to project along; where the normal vanishes (a bow tie), the axis of the least extent would do as well as
  // any: x.
  static int projection_axis(const geom::dvec3& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    if (x == 0 && y == 0 && z == 0) return 2;
    if (x >= y && x >= z) return 0;
    return y >= z ? 1 : 2;
  }

  void fan(FaceId id, const FlatFace& flat, std::size_t start, Block& block) {
    const Ring& ring = flat.rings[0];
    const auto corner = [&](std::size_t i) { return flat.ids[ring[(start + i) % ring.size()]]; };
    const std::size_t last = ring.size() - 2;
    for (std::size_t i = 1; i <= last; ++i) {
      emit(id, {corner(0), corner(i), corner(i + 1)}, {i == 1, true, i == last}, block);
    }
  }

  void constrained(FaceId id, const FlatFace& flat, Block& block) {
    // Points that share a projection stand above each other: a face as warped as that has no planar inside.
    std::vector<PlanarPoint> sorted = flat.points;
    std::sort(sorted.begin(), sorted.end());
    const bool stacked = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    const auto triangles =
        stacked ? std::vector<geom::PolygonTriangle>{} : geom::triangulate_rings(flat.points, flat.rings);
    if (triangles.empty()) {
      result_.condition[id] = FaceCondition::RingCrosses;
      return;
    }
    const bool turned = faces_backwards(result_.normal[id]);
    for (const geom::PolygonTriangle& t : triangles) {
      const std::array<PointId, 3> p{flat.ids[t.corners[0]], flat.ids[t.corners[1]], flat.ids[t.corners[2]]};
      if (turned) {
        emit(id, {p[0], p[2], p[1]}, {t.boundary[2], t.boundary[1], t.boundary[0]}, block);
      } else {
        emit(id, p, t.boundary, block);
      }
    }
  }

  static bool faces_backwards(const geom::dvec3& normal) { return normal[projection_axis(normal)] < 0; }

  void emit(FaceId id, std::array<PointId, 3> points, std::array<bool, 3> boundary, Block& block) {
    const auto smallest = std::min_element(points.begin(), points.end()) - points.begin();
    std::rotate(points.begin(), points.begin() + smallest, points.end());
    std::rotate(boundary.begin(), boundary.begin() + smallest, boundary.end());
    if (geom::collinear(model_.points[points[0]], model_.points[points[1]], model_.points[points[2]])) return;
    block.triangles.push_back({points, id});
    block.boundaries.push_back(boundary);
  }

  const Scene& scene_;
  const LatticeModel& model_;
  double tolerance_;
  std::int64_t tolerance_pitches_;
  FaceTriangles& result_;
};

Int128 doubled_area(std::span<const PointId> corners, const LatticeModel& model, int u, int v) {
  const auto coordinate = [&](PointId id, int axis) {
    const LatticePoint& p = model.points[id];
    return std::int64_t{axis == 0 ? p.x : axis == 1 ? p.y : p.z};
  };
  Int128 sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PointId a = corners[i], b = corners[(i + 1) % corners.size()];
    sum += coordinate(a, u) * coordinate(b, v) - coordinate(a, v) * coordinate(b, u);
  }
  return sum;
}

}  // namespace

geom::dvec3 newell_normal(const Scene& scene, const LatticeModel& model, const Face& face) {
  geom::dvec3 normal{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    Int128 total = 0;
    for (const Loop& loop : scene.loops_of(face)) {
      total += doubled_area(model.corners_of(loop), model, (axis + 1) % 3, (axis + 2) % 3);
    }
    normal[axis] = static_cast<double>(total);
  }
  return normal;
}

FaceTriangles triangulate_faces(const Scene& scene, const LatticeModel& model, const geom::Tolerance& tolerance) {
  FaceTriangles result;
  const std::size_t count = scene.faces.size();
  result.condition.assign(count, FaceCondition::Sound);
  result.flaw.assign(count, RingFlaw::None);
  result.normal.assign(count, geom::dvec3{0, 0, 0});
  const std::size_t block_count = (count + kFacesPerBlock - 1) / kFacesPerBlock;
  std::vector<Block> blocks(block_count);
  tbb::parallel_for(std::size_t{0}, block_count, [&](std::size_t b) {
    FaceTriangulator triangulator(scene, model, tolerance, result);
    const std::size_t end = std::min(count, (b + 1) * kFacesPerBlock);
    for (std::size_t id = b * kFacesPerBlock; id < end; ++id) {
      triangulator.triangulate(static_cast<FaceId>(id), blocks[b]);
    }
  });
  for (Block& block : blocks) {
    for (std::size_t i = 0; i < block.triangles.size(); ++i) {
      const FaceTriangle& t = block.triangles[i];
      result.triangles.push_back(t);
      result.geometry.emplace_back(
          std::array{model.points[t.points[0]], model.points[t.points[1]], model.points[t.points[2]]},
          block.boundaries[i]);
    }
    block = {};
  }
  return result;
}

}  // namespace rad::validate
