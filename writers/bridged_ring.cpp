#include "writers/bridged_ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "geom/lattice.h"
#include "geom/predicates.h"

namespace rad::writers {
namespace {

using geom::LatticePoint;
using geom::PlanarPoint;
using geom::Sign;
using scene::VertexId;

struct Corner {
  std::uint32_t id = 0;  ///< index into Scene::corners
  LatticePoint place;
  PlanarPoint flat;
};
using Ring = std::vector<Corner>;

const Corner& after(const Ring& ring, std::size_t i) { return ring[i + 1 < ring.size() ? i + 1 : 0]; }
const Corner& before(const Ring& ring, std::size_t i) { return ring[i > 0 ? i - 1 : ring.size() - 1]; }

geom::Int128 doubled_area(const Ring& ring) {
  geom::Int128 sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanarPoint &a = ring[i].flat, &b = after(ring, i).flat;
    sum += geom::Int128{a.u} * b.v - geom::Int128{a.v} * b.u;
  }
  return sum;
}

// The axis along which the rings project to the largest area.
int flattest_axis(const std::vector<Ring>& rings) {
  std::array<geom::Int128, 3> areas{};
  for (int axis = 0; axis < 3; ++axis) {
    Ring flat = rings[0];
    for (Corner& corner : flat) corner.flat = geom::project(corner.place, axis);
    const geom::Int128 area = doubled_area(flat);
    areas[axis] = area < 0 ? -area : area;
  }
  return static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
}

bool opposite(Sign a, Sign b) { return a != Sign::Zero && b == -a; }

bool cross_properly(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d) {
  return opposite(geom::orient2d(a, b, c), geom::orient2d(a, b, d)) &&
         opposite(geom::orient2d(c, d, a), geom::orient2d(c, d, b));
}

/// Joins the holes of one face to its outer loop, which runs counter-clockwise as projected.
class Bridging {
 public:
  Bridging(Ring outer, std::vector<Ring> holes, std::int64_t clearance)
      : ring_(std::move(outer)), holes_(std::move(holes)), clearance_(clearance) {}

  // From the right to the left: the rightmost corner of the next hole always sees the ring, whatever lies left of it.
  Ring join() {
    for (Ring& hole : holes_) std::rotate(hole.begin(), rightmost(hole), hole.end());
    std::sort(holes_.begin(), holes_.end(), [](const Ring& a, const Ring& b) { return b[0].flat < a[0].flat; });
    for (done_ = 0; done_ < holes_.size(); ++done_) splice(holes_[done_], best_bridge(holes_[done_]));
    return std::move(ring_);
  }

 private:
  struct Bridge {
    std::size_t ring = 0;
    std::size_t hole = 0;
  };

  static Ring::iterator rightmost(Ring& hole) {
    return std::max_element(hole.begin(), hole.end(), [](const Corner& a, const Corner& b) { return a.flat < b.flat; });
  }

  Bridge best_bridge(const Ring& hole) const {
    for (const std::int64_t clearance : {clearance_, clearance_ / 10, std::int64_t{0}}) {
      for (std::size_t j = 0; j < hole.size(); ++j) {
        if (const auto i = nearest_visible(hole[j], clearance)) return {*i, j};
      }
    }
    return {0, 0};
  }

  std::optional<std::size_t> nearest_visible(const Corner& from, std::int64_t clearance) const {
    std::vector<std::pair<std::int64_t, std::size_t>> order;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      order.emplace_back(geom::squared_distance(from.place, ring_[i].place), i);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [distance, i] : order) {
      if (distance > 0 && opens_towards(i, from) && clear(from, ring_[i], clearance)) return i;
    }
    return std::nullopt;
  }

  // Whether the inside of the ring at corner i holds the direction to `target`: bridges made before leave several
  // corners in one place, and only one of them has the target in its sector.
  bool opens_towards(std::size_t i, const Corner& target) const {
    const PlanarPoint &a = before(ring_, i).flat, &b = ring_[i].flat, &c = after(ring_, i).flat;
    const bool left_of_arrival = geom::orient2d(a, b, target.flat) == Sign::Positive;
    const bool left_of_departure = geom::orient2d(b, c, target.flat) == Sign::Positive;
    const bool convex = geom::orient2d(a, b, c) == Sign::Positive;
    return convex ? left_of_arrival && left_of_departure : left_of_arrival || left_of_departure;
  }

  bool clear(const Corner& from, const Corner& to, std::int64_t clearance) const {
    if (!clear_of(ring_, from, to, clearance)) return false;
    for (std::size_t i = done_; i < holes_.size(); ++i) {
      if (!clear_of(holes_[i], from, to, clearance)) return false;
    }
    return true;
  }

  static bool clear_of(const Ring& ring, const Corner& from, const Corner& to, std::int64_t clearance) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Corner& corner = ring[i];
      if (cross_properly(from.flat, to.flat, corner.flat, after(ring, i).flat)) return false;
      if (corner.place == from.place || corner.place == to.place) continue;
      if (geom::point_within_segment(corner.place, from.place, to.place, clearance)) return false;
    }
    return true;
  }

  void splice(const Ring& hole, Bridge bridge) {
    Ring detour;
    for (std::size_t k = 0; k <= hole.size(); ++k) detour.push_back(hole[(bridge.hole + k) % hole.size()]);
    detour.push_back(ring_[bridge.ring]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(bridge.ring) + 1, detour.begin(), detour.end());
  }

  Ring ring_;
  std::vector<Ring> holes_;
  std::size_t done_ = 0;
  std::int64_t clearance_;
};

bool finite(const geom::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::optional<geom::Box> box_of(const scene::Scene& scene, const scene::Face& face) {
  geom::Box box;
  for (const scene::Loop& loop : scene.loops_of(face)) {
    for (const VertexId id : scene.corners_of(loop)) {
      if (!finite(scene.vertices[id])) return std::nullopt;
      box.add(scene.vertices[id]);
    }
  }
  return box;
}

std::vector<Ring> flat_rings(const scene::Scene& scene, const scene::Face& face, const geom::Lattice& lattice) {
  std::vector<Ring> rings;
  for (const scene::Loop& loop : scene.loops_of(face)) {
    Ring ring;
    for (std::uint32_t id = loop.first; id < loop.first + loop.count; ++id) {
      ring.push_back({id, lattice.nearest(scene.vertices[scene.corners[id]]), {}});
    }
    if (!ring.empty()) rings.push_back(std::move(ring));
  }
  return rings;
}

// Flattens so that the outer ring runs counter-clockwise and the holes clockwise.
void project(std::vector<Ring>& rings) {
  const int axis = flattest_axis(rings);
  for (Ring& ring : rings) {
    for (Corner& corner : ring) corner.flat = geom::project(corner.place, axis);
  }
  if (doubled_area(rings[0]) < 0) {
    for (Ring& ring : rings) {
      for (Corner& corner : ring) corner.flat.u = -corner.flat.u;
    }
  }
  for (std::size_t i = 1; i < rings.size(); ++i) {
    if (doubled_area(rings[i]) > 0) std::reverse(rings[i].begin(), rings[i].end());
  }
}

}  // namespace

std::vector<std::uint32_t> bridged_ring(const scene::Scene& scene, const scene::Face& face) {
  const scene::Loop& outer = scene.loops[face.first_loop];
  std::vector<std::uint32_t> corners(outer.count);
  std::iota(corners.begin(), corners.end(), outer.first);
  const std::optional<geom::Box> box = box_of(scene, face);
  if (face.loop_count == 1 || outer.count == 0 || !box || box->empty()) return corners;

  const geom::Lattice lattice = geom::lattice_for(*box);
  std::vector<Ring> rings = flat_rings(scene, face, lattice);
  project(rings);
  constexpr double kClearanceShare = 1e-4;
  const auto clearance = static_cast<std::int64_t>(kClearanceShare * box->diagonal() / lattice.pitch);
  Ring first = std::move(rings.front());
  rings.erase(rings.begin());
  corners.clear();
  for (const Corner& corner : Bridging(std::move(first), std::move(rings), clearance).join()) {
    corners.push_back(corner.id);
  }
  return corners;
}

}  // namespace rad::writers
