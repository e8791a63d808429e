#include "validate/sight_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geom/segment_distance.h"
#include "geom/triangle_meeting.h"

namespace rad::validate {
namespace {

using geom::LatticePoint;
using Corners = std::array<LatticePoint, 3>;

// Ends of lines of sight have barycentric coordinates in sixteenths: on the lattice sixteen times as fine they lie in
// their triangles exactly. Coordinates are then below 2^30 even in open space, twice the diagonal away, and differences
// below 2^31, cross products below 2^63: predicates keep within 64 and 128 bits.
constexpr int kShares = 16;

geom::BoxTree tree_of(const Context& context, const Sheets& sheets) {
  std::vector<geom::LatticeBox> boxes;
  boxes.reserve(sheets.size());
  for (const auto& t : sheets.triangles) {
    boxes.push_back(
        geom::box_of(std::array{context.model.points[t[0]], context.model.points[t[1]], context.model.points[t[2]]}));
  }
  return geom::BoxTree(std::move(boxes));
}

double diagonal_of(std::span<const LatticePoint> points) {
  if (points.empty()) return 1;
  const geom::LatticeBox box = geom::box_of(points);
  dvec3 extent;
  for (int axis = 0; axis < 3; ++axis) extent[axis] = static_cast<double>(box.high[axis]) - box.low[axis];
  return glm::length(extent) + 1;
}

// SplitMix64 of a counter: the numbers of a ray do not depend on those of others.
double random_unit(std::uint64_t ray, std::uint64_t dimension) {
  std::uint64_t z = (ray * 8 + dimension + 1) * 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

LatticePoint finer(const LatticePoint& p) { return {p.x * kShares, p.y * kShares, p.z * kShares}; }

dvec3 in_pitches(const LatticePoint& fine) { return geom::as_vector(fine) / static_cast<double>(kShares); }

/// Sixteenths of the three corners in the order of space, each at least one.
using Shares = std::array<int, 3>;

Shares nearest_shares(const std::array<double, 3>& barycentric) {
  Shares shares{};
  for (std::size_t i = 0; i < 3; ++i) {
    shares[i] = std::clamp(static_cast<int>(std::lround(barycentric[i] * kShares)), 1, kShares - 2);
  }
  while (shares[0] + shares[1] + shares[2] != kShares) {
    auto& largest = *std::max_element(shares.begin(), shares.end());
    largest += shares[0] + shares[1] + shares[2] < kShares ? 1 : -1;
  }
  return shares;
}

Shares random_shares(std::uint64_t ray) {
  const double root = std::sqrt(random_unit(ray, 1)), other = random_unit(ray, 2);
  return nearest_shares({1 - root, root * (1 - other), root * other});
}

dvec3 cosine_direction(const dvec3& normal, std::uint64_t ray) {
  const dvec3 across = std::abs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(glm::cross(normal, across)), v = glm::cross(normal, u);
  const double radius = std::sqrt(random_unit(ray, 3)), angle = 2 * std::numbers::pi * random_unit(ray, 4);
  const double height = std::sqrt(std::max(0.0, 1 - radius * radius));
  return u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)) + normal * height;
}

}  // namespace

/// What one search looks at again and again.
class SightLines::Search {
 public:
  Search(const SightLines& lines, std::span<const BackSide> backs) : lines_(lines), backs_(backs.begin(), backs.end()) {
    std::sort(backs_.begin(), backs_.end(), [&](const BackSide& a, const BackSide& b) {
      return std::pair(in_order(a.triangle), a.side) < std::pair(in_order(b.triangle), b.side);
    });
    double sum = 0;
    for (const BackSide& back : backs_) area_up_to_.push_back(sum += plane(back.triangle).normal_length);
  }

  std::optional<SightLine> run(int rays, const std::function<bool(FaceId)>& counts) {
    for (int ray = 0; ray < rays; ++ray) {
      const auto line = along_ray(static_cast<std::uint64_t>(ray), (ray + random_unit(ray, 0)) / rays);
      if (line && counts(line->front)) return line;
    }
    return std::nullopt;
  }

 private:
  struct End {
    LatticePoint fine{};
    std::optional<std::uint32_t> triangle;  ///< none in open space
  };

  [[nodiscard]] std::array<PointId, 3> in_order(std::uint32_t triangle) const {
    auto ids = lines_.space_.sheets.triangles[triangle];
    std::sort(ids.begin(), ids.end());
    return ids;
  }
  [[nodiscard]] Corners corners(std::uint32_t triangle) const {
    const auto& t = lines_.space_.sheets.triangles[triangle];
    const auto& points = lines_.context_.model.points;
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
  [[nodiscard]] geom::TrianglePlane plane(std::uint32_t triangle) const {
    const Corners c = corners(triangle);
    return {c[0], c[1], c[2]};
  }
  [[nodiscard]] std::array<dvec3, 3> vectors(std::uint32_t triangle) const {
    const Corners c = corners(triangle);
    return {geom::as_vector(c[0]), geom::as_vector(c[1]), geom::as_vector(c[2])};
  }

  [[nodiscard]] LatticePoint fine_point(std::uint32_t triangle, const Shares& shares) const {
    LatticePoint sum{};
    const auto ids = in_order(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      const LatticePoint& p = lines_.context_.model.points[ids[i]];
      sum = {sum.x + shares[i] * p.x, sum.y + shares[i] * p.y, sum.z + shares[i] * p.z};
    }
    return sum;
  }

  // The side of a triangle on which a fine point lies: 0, 1, or -1 in its plane.
  [[nodiscard]] int side_of(std::uint32_t triangle, const LatticePoint& fine) const {
    const Corners c = corners(triangle);
    const geom::Sign sign = geom::orient3d(finer(c[0]), finer(c[1]), finer(c[2]), fine);
    return sign == geom::Sign::Zero ? -1 : sign == geom::Sign::Positive ? 0 : 1;
  }

  std::optional<SightLine> along_ray(std::uint64_t ray, double share_of_area) {
    const auto at = std::lower_bound(area_up_to_.begin(), area_up_to_.end(), share_of_area * area_up_to_.back());
    const BackSide& back = backs_[std::min<std::size_t>(at - area_up_to_.begin(), backs_.size() - 1)];
    const auto& normal = plane(back.triangle).normal;
    const dvec3 outward = glm::normalize(dvec3(normal.x, normal.y, normal.z)) * (back.side == 0 ? 1.0 : -1.0);
    const End start{fine_point(back.triangle, random_shares(ray)), back.triangle};
    const dvec3 direction = cosine_direction(outward, ray);
    const auto hit = first_hit(in_pitches(start.fine), direction, back.triangle);
    const std::optional<End> end = hit ? front_end(*hit, start.fine) : open_end(back, start.fine, direction);
    if (!end || side_of(back.triangle, end->fine) != back.side || !is_free(start, *end)) return std::nullopt;
    const int end_side = hit ? side_of(*end->triangle, start.fine) : 0;
    return SightLine{{in_pitches(end->fine), in_pitches(start.fine)},
                     lines_.space_.back(back.triangle, back.side),
                     hit ? lines_.space_.sheets.front[*end->triangle][end_side] : kNoFace};
  }

  struct Hit {
    std::uint32_t triangle = 0;
    double distance = 0;
    std::array<double, 3> barycentric{};  ///< of the corners in the order of space
  };

  [[nodiscard]] std::optional<Hit> first_hit(const dvec3& from, const dvec3& direction, std::uint32_t own) const {
    std::optional<Hit> first;
    lines_.tree_.for_each_near_segment(from, from + direction * lines_.farthest_, 1, [&](std::uint32_t triangle) {
      if (triangle == own) return;
      const auto hit = hit_of(from, direction, triangle);
      if (!hit || (first && first->distance < hit->distance)) return;
      if (first && first->distance == hit->distance && in_order(first->triangle) < in_order(triangle)) return;
      first = hit;
    });
    return first;
  }

  // Möller and Trumbore, rounded: it only proposes.
  [[nodiscard]] std::optional<Hit> hit_of(const dvec3& from, const dvec3& direction, std::uint32_t triangle) const {
    const auto ids = in_order(triangle);
    std::array<dvec3, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = geom::as_vector(lines_.context_.model.points[ids[i]]);
    const dvec3 u = c[1] - c[0], v = c[2] - c[0], across = glm::cross(direction, v);
    const double determinant = glm::dot(u, across);
    if (determinant == 0) return std::nullopt;
    const dvec3 offset = from - c[0], other = glm::cross(offset, u);
    const double b1 = glm::dot(offset, across) / determinant, b2 = glm::dot(direction, other) / determinant;
    const double distance = glm::dot(v, other) / determinant;
    if (b1 < 0 || b2 < 0 || b1 + b2 > 1 || distance <= 0) return std::nullopt;
    return Hit{triangle, distance, {1 - b1 - b2, b1, b2}};
  }

  // Nothing where the ray meets a back.
  [[nodiscard]] std::optional<End> front_end(const Hit& hit, const LatticePoint& start) const {
    const int side = side_of(hit.triangle, start);
    if (side < 0 || lines_.space_.sheets.front[hit.triangle][side] == kNoFace) return std::nullopt;
    return End{fine_point(hit.triangle, nearest_shares(hit.barycentric)), hit.triangle};
  }

  [[nodiscard]] std::optional<End> open_end(const BackSide& back, const LatticePoint& start,
                                            const dvec3& direction) const {
    const bool open = lines_.space_.cell(back.triangle, back.side) == kOpenSpace;
    if (!open || lines_.space_.has_emitters) return std::nullopt;
    const dvec3 end = geom::as_vector(start) + direction * (lines_.farthest_ * kShares);
    return End{{static_cast<std::int32_t>(std::lround(end.x)), static_cast<std::int32_t>(std::lround(end.y)),
                static_cast<std::int32_t>(std::lround(end.z))},
               std::nullopt};
  }

  [[nodiscard]] bool share_a_corner(std::uint32_t a, std::uint32_t b) const {
    const auto &p = lines_.space_.sheets.triangles[a], &q = lines_.space_.sheets.triangles[b];
    return std::ranges::any_of(p, [&](PointId id) { return std::ranges::find(q, id) != q.end(); });
  }

  [[nodiscard]] bool is_free(const End& start, const End& end) const {
    const auto tolerance = static_cast<double>(lines_.context_.tolerance.pitches);
    const geom::Segment segment{in_pitches(start.fine), in_pitches(end.fine)};
    bool free = true;
    lines_.tree_.for_each_near_segment(segment[0], segment[1], tolerance + 1, [&](std::uint32_t triangle) {
      if (!free || triangle == start.triangle || triangle == end.triangle) return;
      const Corners c = corners(triangle);
      free = !geom::segment_meets_triangle(start.fine, end.fine, {finer(c[0]), finer(c[1]), finer(c[2])});
      if (!free || share_a_corner(triangle, *start.triangle)) return;
      if (end.triangle && share_a_corner(triangle, *end.triangle)) return;
      free = geom::length(geom::shortest_between(segment, vectors(triangle))) > tolerance;
    });
    return free;
  }

  const SightLines& lines_;
  std::vector<BackSide> backs_;     ///< in the order of space
  std::vector<double> area_up_to_;  ///< sums, the last is the whole
};

SightLines::SightLines(const Context& context, const LitSpace& space)
    : context_(context),
      space_(space),
      tree_(tree_of(context, space.sheets)),
      farthest_(2 * diagonal_of(context.model.points)) {}

std::optional<SightLine> SightLines::find(std::span<const BackSide> backs, int rays,
                                          const std::function<bool(FaceId front)>& counts) const {
  if (backs.empty()) return std::nullopt;
  return Search(*this, backs).run(rays, counts);
}

}  // namespace rad::validate
