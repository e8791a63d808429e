#include "validate/thin_features.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <tuple>

#include "geom/box_tree.h"
#include "validate/parts.h"

namespace rad::validate {
namespace {

using geom::LatticeTriangle;

constexpr std::size_t kTrianglesPerBlock = 1024;
// Where almost every triangle lies near almost every other. Such a scene is judged in part only (find_contacts).
constexpr std::size_t kMostPairsOfBlock = 4'000'000;
constexpr std::size_t kMostFoundOfBlock = 64'000;
// Triangles that share an edge and are no farther apart lie on each other: rounding to the lattice has moved the ends
// by a pitch each.
constexpr double kRoundedPitches = 2;

/// Triangles by the side that they look to, as seen along a direction that few models are built along. Those that
/// nearly look across it are on both sides, so that each of two opposite triangles is on a side of its own.
struct Sides {
  std::vector<std::uint32_t> front, back;  ///< ids, ascending
  std::vector<bool> both;                  ///< per triangle

  explicit Sides(std::span<const LatticeTriangle> triangles) : both(triangles.size()) {
    // Opposite normals of near-parallel triangles are at most 2.6 degrees from one line: sine 0.045.
    constexpr double kAcross = 0.05;
    const dvec3 direction(0.5306, 0.6118, 0.5866);  // of unit length
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
      const geom::TrianglePlane& plane = triangles[id].plane;
      const dvec3 normal(static_cast<double>(plane.normal.x), static_cast<double>(plane.normal.y),
                         static_cast<double>(plane.normal.z));
      const double reach = glm::dot(normal, direction);
      const bool in_front = reach > -kAcross * plane.normal_length, behind = reach < kAcross * plane.normal_length;
      if (in_front) front.push_back(id);
      if (behind) back.push_back(id);
      both[id] = in_front && behind;
    }
  }
};

/// Looks for facing sides among pairs of triangles; one for each block of the search.
class SideSearch {
 public:
  SideSearch(const Context& context, std::int64_t reach) : context_(&context), reach_(reach) {}

  [[nodiscard]] bool full() const { return pairs_ >= kMostPairsOfBlock || found.size() >= kMostFoundOfBlock; }

  void examine(std::uint32_t i, std::uint32_t j) {
    ++pairs_;
    const FaceTriangles& all = context_->triangles;
    if (all.triangles[i].face == all.triangles[j].face) return;
    if (!geom::near_parallel(all.geometry[i], all.geometry[j])) return;
    if (geom::dot(all.geometry[i].plane.normal, all.geometry[j].plane.normal) > 0) return;
    if (all.triangles[j].points < all.triangles[i].points) std::swap(i, j);
    const LatticeTriangle &a = all.geometry[i], &b = all.geometry[j];
    const int shared = shared_points(all.triangles[i], all.triangles[j]);
    if (shared == 3) return;
    if (geom::all_on_one_side(geom::sides_of(a, b.plane, reach_))) return;
    if (geom::all_on_one_side(geom::sides_of(b, a.plane, reach_))) return;
    keep(i, j, geom::parallel_overlap(a, b), shared);
  }

  std::vector<ThinFeature> found;

 private:
  static int shared_points(const FaceTriangle& a, const FaceTriangle& b) {
    int shared = 0;
    for (const PointId p : a.points) shared += std::ranges::count(b.points, p) > 0 ? 1 : 0;
    return shared;
  }

  static bool coplanar(const LatticeTriangle& a, const LatticeTriangle& b) {
    return std::ranges::all_of(b.points, [&](const geom::LatticePoint& p) { return a.plane.value(p) == 0; });
  }

  void keep(std::uint32_t i, std::uint32_t j, const geom::ParallelOverlap& overlap, int shared) {
    const FaceTriangles& all = context_->triangles;
    const double apart = std::abs(overlap.height);
    if (2 * overlap.region.area <= static_cast<double>(context_->tolerance.pitches) * overlap.region.diameter) return;
    if (apart > static_cast<double>(reach_) || (shared == 2 && apart <= kRoundedPitches)) return;
    if (coplanar(all.geometry[i], all.geometry[j])) return;
    const FaceId a = all.triangles[i].face, b = all.triangles[j].face;
    found.push_back({{std::min(a, b), std::max(a, b)},
                     overlap.height > 0 ? ThinKind::Slit : ThinKind::Plate,
                     apart,
                     overlap.region.area,
                     overlap.region.centroid});
  }

  const Context* context_;
  std::int64_t reach_;
  std::size_t pairs_ = 0;
};

geom::BoxTree tree_of(const FaceTriangles& triangles, std::span<const std::uint32_t> ids) {
  std::vector<geom::LatticeBox> boxes(ids.size());
  tbb::parallel_for(std::size_t{0}, boxes.size(),
                    [&](std::size_t i) { boxes[i] = geom::box_of(triangles.geometry[ids[i]].points); });
  return geom::BoxTree(std::move(boxes));
}

std::vector<ThinFeature> facing_triangles(const Context& context, std::int64_t reach) {
  const FaceTriangles& triangles = context.triangles;
  const Sides sides(triangles.geometry);
  const geom::BoxTree tree = tree_of(triangles, sides.back);
  std::vector<SideSearch> blocks((sides.front.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock,
                                 SideSearch(context, reach));
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    const std::size_t first = b * kTrianglesPerBlock;
    for (std::size_t k = first; k < std::min(sides.front.size(), first + kTrianglesPerBlock); ++k) {
      const std::uint32_t i = sides.front[k];
      const auto around = geom::box_of(triangles.geometry[i].points, static_cast<std::int32_t>(reach));
      tree.for_each_meeting(around, [&](std::uint32_t at) {
        const std::uint32_t j = sides.back[at];
        const bool again = i >= j && sides.both[i] && sides.both[j];
        if (!again && !blocks[b].full()) blocks[b].examine(i, j);
      });
    }
  });
  std::vector<ThinFeature> found;
  for (const SideSearch& block : blocks) found.insert(found.end(), block.found.begin(), block.found.end());
  return found;
}

void keep_those_of_one_part(const Context& context, std::vector<ThinFeature>& features) {
  if (features.empty()) return;
  const Parts parts = find_parts(context);
  std::erase_if(features, [&](const ThinFeature& feature) {
    return !parts.together(context.topology, feature.faces[0], feature.faces[1]);
  });
}

// One for each pair of faces and kind: the whole area, the place where it is thinnest.
std::vector<ThinFeature> merged(std::vector<ThinFeature> features) {
  const auto pair = [](const ThinFeature& f) { return std::tuple(f.faces, f.kind); };
  const auto key = [&](const ThinFeature& f) {
    return std::tuple(pair(f), f.thickness, f.area, f.point.x, f.point.y, f.point.z);
  };
  tbb::parallel_sort(features.begin(), features.end(),
                     [&](const ThinFeature& a, const ThinFeature& b) { return key(a) < key(b); });
  std::vector<ThinFeature> result;
  for (const ThinFeature& feature : features) {
    if (!result.empty() && pair(result.back()) == pair(feature)) {
      result.back().area += feature.area;
    } else {
      result.push_back(feature);
    }
  }
  return result;
}

}  // namespace

double ThinFeature::kept_pitches() const {
  // Of a plate the rim must stay open as well. A pitch less than what was measured, for rounding.
  return std::floor((thickness - 1) / static_cast<double>(kStripTolerances));
}

std::vector<ThinFeature> find_facing_sides(const Context& context, std::int64_t reach) {
  std::vector<ThinFeature> features = facing_triangles(context, reach);
  keep_those_of_one_part(context, features);
  features = merged(std::move(features));
  for (ThinFeature& feature : features) {
    if (context.precedes(feature.faces[1], feature.faces[0])) std::swap(feature.faces[0], feature.faces[1]);
  }
  return features;
}

std::vector<ThinFeature> find_thin_features(const Context& context) {
  std::vector<ThinFeature> features = find_facing_sides(context, geom::weld_pitches(context.tolerance));
  const std::vector<ThinFeature> strips = find_strips(context);
  features.insert(features.end(), strips.begin(), strips.end());
  return features;
}

}  // namespace rad::validate
