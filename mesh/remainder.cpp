#include "mesh/remainder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "mesh/lengths.h"
#include "mesh/shape_points.h"
#include "mesh/smoothing.h"
#include "mesh/spaced_points.h"

namespace rad::mesh {
namespace {

using geom::PlanePoint;

// A triangle lower than this many T would read as a T-vertex once it is written and judged again.
constexpr double kLeastHeightInTolerances = 1.02;
// Where the third corner of a triangle is nearer than this share of a long edge to its middle, the point that divides
// it goes into the triangle on the other side.
constexpr double kFlatShare = 0.3;
// Points added in one round keep this share of the patch length.
constexpr double kRoundSpacingShare = 0.5;
// Every round halves what is too long; the size of the lattice over the shortest patch is below 2^20.
constexpr int kMostRounds = 24;
constexpr int kMostRoundsInAll = 3 * kMostRounds;
// More hardly move anything.
constexpr int kSmoothingSweeps = 4;

double distance(const PlanePoint& a, const PlanePoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

PlanePoint middle(const PlanePoint& a, const PlanePoint& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

double distance_to_edge(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  return geom::distance_to_segment({p.x, p.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0});
}

struct LongEdge {
  double length;
  std::uint32_t triangle;
  std::size_t edge;
};

class RemainderMesher {
 public:
  RemainderMesher(Remainder& remainder, const FaceFrame& frame, const FaceLengths& lengths, const ClearZone& zone)
      : remainder_(remainder), frame_(frame), lengths_(lengths), zone_(zone), spoiled_(lengths.spacing) {}

  // Graded patches are well shaped from the start; on the grid it is enough that what stays too low when nothing is too
  // long any more gets points.
  bool run(std::vector<PatchCorners>& patches) {
    int divided = 0, shaped = 0;
    for (int round = 0;; ++round) {
      if (!triangulate()) return remainder_.outline.empty();
      if (round < kMostRoundsInAll && drop_spoilers(shaped < kMostRounds)) continue;
      if (graded() && shaped < kMostRounds && better_shapes(shaped)) continue;
      if (graded()) smooth_free_points();
      partner_ = quad_partners(triangles_, remainder_.points, {lengths_.longest, flatness()});
      if (divided++ < kMostRounds && divide_long_edges()) continue;
      if (graded() || shaped >= kMostRounds || !better_shapes(shaped)) break;
    }
    append_patches(patches);
    return true;
  }

 private:
  // A quarter of T off the plane is what the repair leaves to a face.
  [[nodiscard]] std::int64_t flatness() const { return std::max<std::int64_t>(1, lengths_.tolerance / 4); }
  [[nodiscard]] const PlanePoint& at(std::uint32_t point) const { return remainder_.points.plane[point]; }

  bool triangulate() {
    std::vector<std::uint32_t> used, index(remainder_.state.size(), 0);
    std::vector<geom::PlanarPoint> flat;
    for (std::uint32_t p = 0; p < remainder_.state.size(); ++p) {
      if (remainder_.state[p] == PointState::Unused) continue;
      index[p] = static_cast<std::uint32_t>(used.size());
      used.push_back(p);
      flat.push_back(remainder_.points.flat[p]);
    }
    const auto reindexed = [&](std::vector<PointEdge> edges) {
      for (PointEdge& edge : edges) edge = {index[edge[0]], index[edge[1]]};
      return edges;
    };
    auto triangles = geom::triangulate_region(flat, reindexed(remainder_.outline), reindexed(remainder_.inner));
    for (auto& triangle : triangles) {
      for (std::uint32_t& corner : triangle.corners) corner = used[corner];
    }
    triangles_ = linked(triangles);
    flip_to_delaunay(triangles_, remainder_.points.flat, remainder_.points.plane);
    return !triangles_.empty();
  }

  [[nodiscard]] double least_height() const {
    return kLeastHeightInTolerances * static_cast<double>(lengths_.tolerance);
  }

  void add_free(const geom::LatticePoint& point) {
    add_point(remainder_.points, frame_, point);
    remainder_.state.push_back(PointState::Free);
  }

  [[nodiscard]] bool graded() const { return lengths_.method == PatchMethod::Graded; }

  void smooth_free_points() {
    std::vector<bool> free;
    for (const PointState state : remainder_.state) free.push_back(state == PointState::Free);
    const double longest = std::numbers::sqrt2 * lengths_.longest;  // the diagonal of a square
    for (int sweep = 0; sweep < kSmoothingSweeps; ++sweep) {
      if (!smooth(triangles_, free, frame_, least_height(), longest, remainder_.points)) return;
      flip_to_delaunay(triangles_, remainder_.points.flat, remainder_.points.plane);
    }
  }

  // Says whether it added points; counts the rounds.
  bool better_shapes(int& rounds) {
    ++rounds;
    const auto added = shape_points(triangles_, remainder_.points, frame_, lengths_, least_height(), {spoiled_, zone_});
    for (const geom::LatticePoint& point : added) {
      add_free(point);
      shaping_points_.resize(remainder_.state.size(), false);
      shaping_points_.back() = true;
    }
    return !added.empty();
  }

  // Free points of triangles that are too low are dropped; says whether there were any. While shapes are still
  // bettered, points that were added for them stay: low triangles at them get points of their own.
  bool drop_spoilers(bool shaping) {
    const double least = least_height();
    bool dropped = false;
    for (const LinkedTriangle& triangle : triangles_) {
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const PlanePoint &a = at(triangle.corner[edge]), &b = at(triangle.corner[(edge + 1) % 3]);
        if (distance_to_edge(at(triangle.opposite(edge)), a, b) >= least) continue;
        dropped |= drop_one({triangle.opposite(edge), triangle.corner[edge], triangle.corner[(edge + 1) % 3]}, shaping);
      }
    }
    return dropped;
  }

  bool drop_one(const std::array<std::uint32_t, 3>& by_preference, bool shaping) {
    for (const std::uint32_t point : by_preference) {
      if (remainder_.state[point] != PointState::Free) continue;
      if (shaping && point < shaping_points_.size() && shaping_points_[point]) continue;
      remainder_.state[point] = PointState::Unused;
      spoiled_.add(remainder_.points.lattice[point]);
      return true;
    }
    return false;
  }

  // Adds points where edges inside the face are too long; says whether it did.
  bool divide_long_edges() {
    SpacedPoints added(std::max(lengths_.spacing, kRoundSpacingShare * lengths_.longest));
    bool any = false;
    for (const LongEdge& edge : long_edges()) {
      const std::optional<geom::LatticePoint> point = dividing_point(edge);
      if (!point || !added.add_if_spaced(*point)) continue;
      add_free(*point);
      any = true;
    }
    return any;
  }

  [[nodiscard]] std::vector<LongEdge> long_edges() const {
    std::vector<LongEdge> edges;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const std::uint32_t s = triangles_[t].across[edge];
        if (s == kNoTriangle || s < t || triangles_[t].fixed[edge] || partner_[t] == s) continue;
        const double length = distance(at(triangles_[t].corner[edge]), at(triangles_[t].corner[(edge + 1) % 3]));
        if (length > lengths_.longest + kLengthRounding) edges.push_back({length, t, edge});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const LongEdge& a, const LongEdge& b) {
      return std::tie(b.length, a.triangle, a.edge) < std::tie(a.length, b.triangle, b.edge);
    });
    return edges;
  }

  // In the middle of the edge, or in the larger of its triangles; nothing where that is too near to what stays.
  [[nodiscard]] std::optional<geom::LatticePoint> dividing_point(const LongEdge& edge) const {
    const auto quad = quad_over(triangles_, edge.triangle, edge.edge);  // a, d, b, c over the edge ab
    const PlanePoint &a = at(quad[0]), &d = at(quad[1]), &b = at(quad[2]), &c = at(quad[3]);
    PlanePoint place = middle(a, b);
    const double to_c = distance(place, c), to_d = distance(place, d);
    if (std::min(to_c, to_d) < kFlatShare * edge.length) {
      const PlanePoint& far = to_c < to_d ? d : c;
      place = {(a.x + b.x + far.x) / 3, (a.y + b.y + far.y) / 3};
    }
    const geom::LatticePoint point = frame_.nearest(place);
    const bool clear = clear_of(triangles_[edge.triangle], place) &&
                       clear_of(triangles_[triangles_[edge.triangle].across[edge.edge]], place);
    if (!clear || spoiled_.any_near(point) || !zone_.leaves_out(point)) return std::nullopt;
    return point;
  }

  // Whether a point keeps its distance from the corners and the fixed edges of a triangle.
  [[nodiscard]] bool clear_of(const LinkedTriangle& triangle, const PlanePoint& point) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanePoint &from = at(triangle.corner[i]), &to = at(triangle.corner[(i + 1) % 3]);
      if (distance(point, from) < lengths_.spacing) return false;
      const bool stays = triangle.fixed[i] || triangle.across[i] == kNoTriangle;
      if (stays && distance_to_edge(point, from, to) < lengths_.spacing) return false;
    }
    return true;
  }

  void append_patches(std::vector<PatchCorners>& patches) const {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto& [corner, across, fixed] = triangles_[t];
      if (partner_[t] == kNoTriangle) {
        patches.push_back({{corner[0], corner[1], corner[2], 0}, 3});
      } else if (t < partner_[t]) {
        const auto edge =
            static_cast<std::size_t>(std::find(across.begin(), across.end(), partner_[t]) - across.begin());
        patches.push_back({quad_over(triangles_, t, edge), 4});
      }
    }
  }

  Remainder& remainder_;
  const FaceFrame& frame_;
  const FaceLengths& lengths_;
  const ClearZone& zone_;
  SpacedPoints spoiled_;              // where points were dropped: none is added there again
  std::vector<bool> shaping_points_;  // by point; shorter than there are points
  std::vector<LinkedTriangle> triangles_;
  std::vector<std::uint32_t> partner_;
};

}  // namespace

void add_point(FacePoints& points, const FaceFrame& frame, const geom::LatticePoint& point) {
  points.lattice.push_back(point);
  points.flat.push_back(frame.flat(point));
  points.plane.push_back(frame.in_plane(point));
}

bool mesh_remainder(Remainder& remainder, const FaceFrame& frame, const FaceLengths& lengths, const ClearZone& zone,
                    std::vector<PatchCorners>& patches) {
  return RemainderMesher(remainder, frame, lengths, zone).run(patches);
}

}  // namespace rad::mesh
