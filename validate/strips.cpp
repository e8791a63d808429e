#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "geom/box_tree.h"
#include "scene/disjoint_sets.h"
#include "validate/thin_features.h"

namespace rad::validate {
namespace {

double diagonal(const geom::LatticeBox& box) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = double(box.high[axis]) - double(box.low[axis]);
    squared += side * side;
  }
  return std::sqrt(squared);
}

geom::LatticeBox box_around(const Context& context, FaceId face) {
  const scene::Loop& outer = context.scene.loops[context.scene.faces[face].first_loop];
  const auto corners = context.model.corners_of(outer);
  geom::LatticeBox box = geom::box_of(std::span(&context.model.points[corners[0]], 1));
  for (const PointId id : corners) box = geom::united(box, geom::box_of(std::span(&context.model.points[id], 1)));
  return box;
}

std::vector<geom::LatticePoint> outline_of(const Context& context, FaceId face) {
  std::vector<geom::LatticePoint> outline;
  const scene::Loop& outer = context.scene.loops[context.scene.faces[face].first_loop];
  for (const PointId id : context.model.corners_of(outer)) outline.push_back(context.model.points[id]);
  return outline;
}

// The least extent across one of its edges: the width of a face whose hull has that edge, and never less than it.
double least_width(std::span<const geom::LatticePoint> outline, const dvec3& normal) {
  double least = std::numeric_limits<double>::max();
  const dvec3 up = glm::normalize(normal);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const dvec3 from = geom::as_vector(outline[i]);
    const dvec3 along = geom::as_vector(outline[(i + 1) % outline.size()]) - from;
    const double length = glm::length(along);
    if (length == 0) continue;
    const dvec3 across = glm::cross(up, along) / length;
    double low = 0, high = 0;
    for (const geom::LatticePoint& point : outline) {
      const double reach = glm::dot(across, geom::as_vector(point) - from);
      low = std::min(low, reach);
      high = std::max(high, reach);
    }
    least = std::min(least, high - low);
  }
  return least;
}

/// Faces narrower than 2 T, put together where they lie in one plane.
class StripSearch {
 public:
  explicit StripSearch(const Context& context)
      : context_(context),
        limit_(static_cast<double>(kStripTolerances * context.tolerance.pitches)),
        width_(context.scene.faces.size(), 0.0) {}

  std::vector<ThinFeature> run() {
    std::vector<ThinFeature> strips;
    if (!measure()) return strips;
    scene::DisjointSets planes(width_.size());
    std::vector<bool> beside_wide(width_.size(), false);
    join(planes, beside_wide);
    const std::map<FaceId, Whole> wholes = wholes_of(planes, beside_wide);
    for (FaceId face = 0; face < width_.size(); ++face) {
      if (width_[face] > 0 && is_strip(wholes.at(planes.find(face)))) strips.push_back(strip_of(face));
    }
    return strips;
  }

 private:
  /// Narrow faces of one plane that share edges.
  struct Whole {
    geom::LatticeBox box;
    double area = 0;
    bool beside_wide = false;  ///< it goes on in a wider face of its plane
  };

  [[nodiscard]] double area(FaceId face) const { return glm::length(context_.triangles.normal[face]) / 2; }

  // False where no face is narrow. A region of width w has an area of at most w times its diameter.
  bool measure() {
    std::atomic<bool> any = false;
    tbb::parallel_for(std::size_t{0}, width_.size(), [&](std::size_t i) {
      const auto face = static_cast<FaceId>(i);
      if (!context_.is_sound(face)) return;
      if (area(face) > limit_ * diagonal(box_around(context_, face))) return;
      const double width = least_width(outline_of(context_, face), context_.triangles.normal[face]);
      if (width > limit_) return;
      width_[i] = width;
      any.store(true, std::memory_order_relaxed);
    });
    return any;
  }

  [[nodiscard]] bool in_one_plane(FaceId a, FaceId b) const {
    const dvec3 &u = context_.triangles.normal[a], &v = context_.triangles.normal[b];
    return glm::dot(u, v) >= geom::kParallelCosine * glm::length(u) * glm::length(v);
  }

  void join(scene::DisjointSets& planes, std::vector<bool>& beside_wide) const {
    for (const Subedge& subedge : context_.topology.subedges) {
      const auto users = context_.topology.coedges_of(subedge);
      if (users.size() != 2) continue;
      const FaceId a = users[0].face, b = users[1].face;
      const bool narrow_a = width_[a] > 0, narrow_b = width_[b] > 0;
      if ((!narrow_a && !narrow_b) || users[0].forward == users[1].forward || !in_one_plane(a, b)) continue;
      if (narrow_a && narrow_b) {
        planes.unite(a, b);
      } else {
        beside_wide[narrow_a ? a : b] = true;
      }
    }
  }

  std::map<FaceId, Whole> wholes_of(scene::DisjointSets& planes, const std::vector<bool>& beside_wide) const {
    std::map<FaceId, Whole> wholes;
    for (FaceId face = 0; face < width_.size(); ++face) {
      if (width_[face] == 0) continue;
      const geom::LatticeBox box = box_around(context_, face);
      const auto [entry, fresh] = wholes.emplace(planes.find(face), Whole{box});
      Whole& whole = entry->second;
      if (!fresh) whole.box = geom::united(whole.box, box);
      whole.area += area(face);
      whole.beside_wide = whole.beside_wide || beside_wide[face];
    }
    return wholes;
  }

  [[nodiscard]] bool is_strip(const Whole& whole) const {
    const double length = diagonal(whole.box);
    const auto least = static_cast<double>(kStripLengthTolerances * context_.tolerance.pitches);
    return !whole.beside_wide && length > least && whole.area <= limit_ * length;
  }

  [[nodiscard]] ThinFeature strip_of(FaceId face) const {
    const dvec3 middle = (context_.centre(face) - context_.model.lattice.origin) / context_.model.lattice.pitch;
    return {{face, kNoFace}, ThinKind::Strip, width_[face], area(face), middle};
  }

  const Context& context_;
  double limit_;               ///< pitches
  std::vector<double> width_;  ///< per face, pitches; 0 where it is not narrow
};

}  // namespace

std::vector<ThinFeature> find_strips(const Context& context) { return StripSearch(context).run(); }

}  // namespace rad::validate
