#include "repair/pair_judge.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geom/triangle_meeting.h"
#include "validate/contacts.h"

namespace rad::repair {
namespace {

// Opposite within 8°; nearly parallel within 2.6°, as lint has it (geom::kParallelCosine).
constexpr double kOppositeCosine = -0.99;
constexpr double kParallelCosine = 0.999;
// Inside these shares of T the lint of the written file sees nothing, whichever way its numbers are rounded.
constexpr double kContactShare = 0.99;
constexpr double kEdgeEndShare = 0.998;
// Turned from each other by less than this they may lie over each other from a common corner on: wider than any cosine
// that "nearly parallel" is held against.
constexpr double kFlapCosine = 0.99;
// Rounded distances are wrong by less than this, pitches.
constexpr double kRounding = 1e-6;

}  // namespace

PairJudge::Corners PairJudge::corners(std::uint32_t i) const {
  const auto& ids = triangle(i).points;
  return {point(ids[0]), point(ids[1]), point(ids[2])};
}

PairJudge::Places PairJudge::places(std::uint32_t i) const {
  const auto& ids = triangle(i).points;
  return {place(ids[0]), place(ids[1]), place(ids[2])};
}

bool PairJudge::kept_apart(std::uint32_t a, std::uint32_t b) const {
  const auto &p = triangle(a).points, &q = triangle(b).points;
  geom::SharedCorners of_b{geom::kNotShared, geom::kNotShared, geom::kNotShared}, of_a = of_b;
  int shared = 0;
  for (std::int8_t i = 0; i < 3; ++i) {
    for (std::int8_t j = 0; j < 3; ++j) {
      if (p[i] != q[j]) continue;
      of_b[j] = i;
      of_a[i] = j;
      ++shared;
    }
  }
  if (shared == 3) return false;
  const double distance = width_ + kRounding;
  const bool flaps = shared > 0 && std::abs(glm::dot(column(a).normal(), column(b).normal())) > kFlapCosine;
  const bool b_is_out = column(a).keeps_out(places(b), of_b, distance, flaps);
  if (shared == 0 && b_is_out) return true;
  if (shared != 0 && !b_is_out) return false;
  return column(b).keeps_out(places(a), of_a, distance, flaps);
}

bool PairJudge::lies_on(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::all_of(
      triangle(a).points, [&](PointId id) { return std::abs(column(b).height(place(id))) <= kContactShare * width_; });
}

bool PairJudge::opposite_contact(std::uint32_t a, std::uint32_t b) const {
  return glm::dot(column(a).normal(), column(b).normal()) <= kOppositeCosine && lies_on(a, b) && lies_on(b, a);
}

// Triangles of one plane map do not overlap in projection, so they cannot meet in space.
bool PairJudge::apart_by_construction(std::uint32_t a, std::uint32_t b) const {
  const ClusterId cluster = triangle(a).cluster;
  return cluster == triangle(b).cluster && cluster != kNoCluster && (set_.folded.empty() || !set_.folded[cluster]);
}

// The middle of `a` lies within T of `b` and over its open inside.
bool PairJudge::middle_on(std::uint32_t a, std::uint32_t b) const {
  if (glm::dot(column(a).normal(), column(b).normal()) < kParallelCosine) return false;
  const Places own = places(a);
  const dvec3 middle = (own[0] + own[1] + own[2]) / 3.0;
  const double away = column(b).height(middle);
  if (std::abs(away) > width_) return false;
  const dvec3& normal = column(b).normal();
  const dvec3 foot = middle - away * normal;
  const Places v = places(b);
  for (int i = 0; i < 3; ++i) {
    // On an edge is on it: the middle may lie on the seam of two triangles.
    if (glm::dot(glm::cross(v[(i + 1) % 3] - v[i], foot - v[i]), normal) < 0) return false;
  }
  return true;
}

void PairJudge::find_point_on_edge(std::uint32_t edge_of, std::uint32_t edge, PointId id, std::uint32_t point_of,
                                   std::vector<Evidence>& found) const {
  const PointId a = triangle(edge_of).points[edge], b = triangle(edge_of).points[(edge + 1) % 3];
  if (geom::distance_to_segment(place(id), place(a), place(b)) > width_ + kRounding) return;
  if (!geom::point_within_segment(point(id), point(a), point(b), lint_.tolerance_)) return;
  const double length = glm::distance(place(a), place(b)), end = kEdgeEndShare * width_;
  const double along = glm::dot(place(id) - place(a), place(b) - place(a)) / length;
  if (along <= end || length - along <= end) return;
  found.push_back({{ViolationKind::PointOnEdge, edge_of, edge, id}, point_of});
}

void PairJudge::find_points_on_edges(std::uint32_t edges_of, std::uint32_t points_of,
                                     std::vector<Evidence>& found) const {
  for (const PointId id : triangle(points_of).points) {
    if (triangle(edges_of).has(id) || std::abs(column(edges_of).height(place(id))) > width_ + kRounding) continue;
    for (std::uint32_t edge = 0; edge < 3; ++edge) find_point_on_edge(edges_of, edge, id, points_of, found);
  }
}

// Its own apex on an edge, and a triangle nowhere thicker than T (RL007): there the apex may be at the end of the
// longest edge.
void PairJudge::judge_alone(std::uint32_t i, std::vector<Evidence>& found) const {
  const auto& ids = triangle(i).points;
  for (std::uint32_t edge = 0; edge < 3; ++edge) find_point_on_edge(i, edge, ids[(edge + 2) % 3], i, found);
  std::uint32_t longest = 0;
  const auto length = [&](std::uint32_t k) { return geom::squared_distance(point(ids[k]), point(ids[(k + 1) % 3])); };
  for (const std::uint32_t k : {1u, 2u}) {
    if (length(k) > length(longest)) longest = k;
  }
  const PointId apex = ids[(longest + 2) % 3];
  if (!geom::point_within_segment(point(apex), point(ids[longest]), point(ids[(longest + 1) % 3]), lint_.tolerance_)) {
    return;
  }
  found.push_back({{ViolationKind::PointOnEdge, i, longest, apex}, i});
}

void PairJudge::judge(std::uint32_t x, std::uint32_t y, std::vector<Evidence>& found) const {
  const auto [a, b] = std::minmax(x, y);
  if (!apart_by_construction(a, b) && !opposite_contact(a, b) &&
      geom::meet_beyond_shared_corners(corners(a), corners(b))) {
    found.push_back({{ViolationKind::Intersection, a, b, 0}, b});
  }
  const bool same = std::ranges::all_of(triangle(a).points, [&](PointId id) { return triangle(b).has(id); });
  if (same) return;
  if (middle_on(a, b)) found.push_back({{ViolationKind::NearCoplanar, a, b, 0}, b});
  if (middle_on(b, a)) found.push_back({{ViolationKind::NearCoplanar, b, a, 0}, a});
  find_points_on_edges(a, b, found);
  find_points_on_edges(b, a, found);
}

bool PairJudge::judge_contact(std::uint32_t x, std::uint32_t y, std::vector<Evidence>& found) const {
  const auto [a, b] = std::minmax(x, y);
  const auto contact = validate::contact_of_lone_triangles(triangle(a).points, corners(a), triangle(b).points,
                                                           corners(b), lint_.tolerance_);
  if (contact.kind == geom::ContactKind::None) return false;
  if (contact.kind != geom::ContactKind::Overlap) {
    found.push_back({{ViolationKind::Contact, a, b, 0}, b});
    return false;
  }
  if (contact.same_facing) found.push_back({{ViolationKind::NearCoplanar, a, b, 0}, b});
  const auto& ids = triangle(a).points;
  return !contact.same_facing && !std::ranges::all_of(ids, [&](PointId id) { return triangle(b).has(id); });
}

}  // namespace rad::repair
