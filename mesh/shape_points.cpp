#include "mesh/shape_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace rad::mesh {
namespace {

using geom::PlanePoint;

// Off-centres lie this many shortest edges away: an apex angle of 24°, ρ = 0.65 for the triangle that they make.
constexpr double kOffCentre = 2.4;
// Shares of the shortest edge that a point keeps from what is there, and from the other points of a round.
constexpr double kClearance = 0.5;
constexpr double kRoundSpacing = 1.2;
// A walk longer than this leads around a hole: the point is not near its triangle.
constexpr int kMostSteps = 256;

double distance(const PlanePoint& a, const PlanePoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The shortest edge of a triangle to be bettered.
struct ShortEdge {
  double length;
  std::uint32_t triangle;
  std::size_t edge;
};

/// Points whose distance follows the length that each was made for, by powers of two.
class GradedPoints {
 public:
  bool add_if_spaced(const geom::LatticePoint& point, double length) {
    const int level = std::ilogb(length);
    for (const int near : {level - 1, level + 1}) {
      const auto known = levels_.find(near);
      if (known != levels_.end() && known->second.any_near(point)) return false;
    }
    return levels_.try_emplace(level, kRoundSpacing * std::ldexp(1.0, level)).first->second.add_if_spaced(point);
  }

 private:
  std::map<int, SpacedPoints> levels_;
};

class ShapeJudge {
 public:
  ShapeJudge(std::span<const LinkedTriangle> triangles, const FacePoints& points, const FaceFrame& frame,
             const FaceLengths& lengths, double least_height)
      : triangles_(triangles), points_(points), frame_(frame), lengths_(lengths), least_height_(least_height) {}

  [[nodiscard]] std::vector<ShortEdge> short_edges() const {
    std::vector<ShortEdge> edges;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const ShortEdge edge = shortest_edge(t);
      const bool own_angle = stays(t, (edge.edge + 1) % 3) && stays(t, (edge.edge + 2) % 3);
      if (!own_angle && poor(t)) edges.push_back(edge);
    }
    std::sort(edges.begin(), edges.end(), [](const ShortEdge& a, const ShortEdge& b) {
      return std::tie(a.length, a.triangle) < std::tie(b.length, b.triangle);
    });
    return edges;
  }

  [[nodiscard]] std::optional<geom::LatticePoint> off_centre(const ShortEdge& edge) const {
    const LinkedTriangle& triangle = triangles_[edge.triangle];
    const PlanePoint &a = at(triangle.corner[edge.edge]), &b = at(triangle.corner[(edge.edge + 1) % 3]);
    const PlanePoint& c = at(triangle.opposite(edge.edge));
    // The circumcentre is this far from the middle of ab on c's side: |ab|/2 times the cotangent of the angle at c.
    const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
    const double to_centre = edge.length / 2 * (ax * bx + ay * by) / std::abs(ax * by - ay * bx);
    const double way = std::min(to_centre, kOffCentre * edge.length) / edge.length;
    const PlanePoint place{(a.x + b.x) / 2 - (b.y - a.y) * way, (a.y + b.y) / 2 + (b.x - a.x) * way};
    const geom::LatticePoint point = frame_.nearest(place);
    const std::uint32_t holder = triangle_at(edge.triangle, frame_.flat(point));
    if (holder == kNoTriangle || !clear(holder, frame_.in_plane(point), edge.length)) return std::nullopt;
    return point;
  }

 private:
  [[nodiscard]] const PlanePoint& at(std::uint32_t point) const { return points_.plane[point]; }
  [[nodiscard]] bool stays(std::uint32_t t, std::size_t edge) const {
    return triangles_[t].fixed[edge] || triangles_[t].across[edge] == kNoTriangle;
  }

  [[nodiscard]] ShortEdge shortest_edge(std::uint32_t t) const {
    ShortEdge shortest{INFINITY, t, 0};
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const double length = distance(at(triangles_[t].corner[edge]), at(triangles_[t].corner[(edge + 1) % 3]));
      if (length < shortest.length) shortest = {length, t, edge};
    }
    return shortest;
  }

  [[nodiscard]] bool poor(std::uint32_t t) const {
    const auto& corner = triangles_[t].corner;
    const std::array<PlanePoint, 3> place{at(corner[0]), at(corner[1]), at(corner[2])};
    if (lengths_.method == PatchMethod::Graded && geom::scaled_shape(place) < kLeastShape) return true;
    const double doubled_area = std::abs((place[1].x - place[0].x) * (place[2].y - place[0].y) -
                                         (place[1].y - place[0].y) * (place[2].x - place[0].x));
    const double longest =
        std::max({distance(place[0], place[1]), distance(place[1], place[2]), distance(place[2], place[0])});
    return doubled_area < least_height_ * longest;
  }

  // Walks to the triangle that holds the point; not across fixed edges.
  [[nodiscard]] std::uint32_t triangle_at(std::uint32_t from, const geom::PlanarPoint& point) const {
    std::uint32_t here = from;
    for (int step = 0; step < kMostSteps; ++step) {
      std::size_t out = 3;
      for (std::size_t edge = 0; edge < 3 && out == 3; ++edge) {
        const auto &a = points_.flat[triangles_[here].corner[edge]],
                   &b = points_.flat[triangles_[here].corner[(edge + 1) % 3]];
        if (geom::orient2d(a, b, point) == geom::Sign::Negative) out = edge;
      }
      if (out == 3) return here;
      if (stays(here, out)) return kNoTriangle;
      here = triangles_[here].across[out];
    }
    return kNoTriangle;
  }

  [[nodiscard]] bool clear(std::uint32_t holder, const PlanePoint& place, double length) const {
    const double least = std::max(lengths_.spacing, kClearance * length);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const PlanePoint &a = at(triangles_[holder].corner[edge]), &b = at(triangles_[holder].corner[(edge + 1) % 3]);
      if (distance(place, a) < least) return false;
      if (stays(holder, edge) &&
          geom::distance_to_segment({place.x, place.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0}) < least) {
        return false;
      }
    }
    return true;
  }

  std::span<const LinkedTriangle> triangles_;
  const FacePoints& points_;
  const FaceFrame& frame_;
  const FaceLengths& lengths_;
  double least_height_;
};

}  // namespace

std::vector<geom::LatticePoint> shape_points(std::span<const LinkedTriangle> triangles, const FacePoints& points,
                                             const FaceFrame& frame, const FaceLengths& lengths, double least_height,
                                             const ShapeObstacles& obstacles) {
  const ShapeJudge judge(triangles, points, frame, lengths, least_height);
  GradedPoints spaced;
  std::vector<geom::LatticePoint> added;
  for (const ShortEdge& edge : judge.short_edges()) {
    const std::optional<geom::LatticePoint> point = judge.off_centre(edge);
    if (!point || obstacles.spoiled.any_near(*point) || !obstacles.zone.leaves_out(*point)) continue;
    if (spaced.add_if_spaced(*point, edge.length)) added.push_back(*point);
  }
  return added;
}

}  // namespace rad::mesh
