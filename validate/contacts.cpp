#include "validate/contacts.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>

#include "geom/box_tree.h"
#include "geom/triangle_column.h"

namespace rad::validate {
namespace {

using geom::ContactKind;
using geom::LatticeBox;
using geom::LatticeTriangle;
using geom::Sides;
using geom::Sign;
using geom::TriangleColumn;
using geom::TriangleContact;

constexpr std::uint32_t kSlotsPerBlock = 1024;

/// What one block of the search may examine and keep.
struct BlockShare {
  std::size_t pairs;
  std::size_t contacts;
};

BlockShare share_of(const SearchLimits& limits, std::size_t block_count) {
  const std::size_t blocks = std::max<std::size_t>(1, block_count);
  return {std::max(limits.least_pairs, limits.pairs / blocks),
          std::max(limits.least_contacts, limits.contacts / blocks)};
}

std::vector<LatticeBox> inflated_boxes(const FaceTriangles& triangles, const geom::Tolerance& tolerance) {
  // Two boxes that are each inflated by half of T or more meet wherever their triangles come within T.
  const auto inflation = static_cast<std::int32_t>((tolerance.pitches + 1) / 2);
  std::vector<LatticeBox> boxes(triangles.geometry.size());
  tbb::parallel_for(std::size_t{0}, boxes.size(),
                    [&](std::size_t i) { boxes[i] = geom::box_of(triangles.geometry[i].points, inflation); });
  return boxes;
}

int shared_points(const FaceTriangle& a, const FaceTriangle& b) {
  int shared = 0;
  for (const PointId p : a.points) {
    for (const PointId q : b.points) shared += p == q ? 1 : 0;
  }
  return shared;
}

bool has_point(const FaceTriangle& triangle, PointId id) {
  return triangle.points[0] == id || triangle.points[1] == id || triangle.points[2] == id;
}

// Whether the edge that a shares with b is one of a's face and not a diagonal inside it.
bool in_outline(const FaceTriangle& a, const LatticeTriangle& ga, const FaceTriangle& b) {
  for (int i = 0; i < 3; ++i) {
    if (has_point(b, a.points[i]) && has_point(b, a.points[(i + 1) % 3])) return ga.boundary[i];
  }
  return false;
}

TriangleContact coincident(const LatticeTriangle& a, const LatticeTriangle& b) {
  TriangleContact contact;
  contact.kind = ContactKind::Overlap;
  contact.size = a.plane.normal_length / 2;
  contact.same_facing = geom::dot(a.plane.normal, b.plane.normal) > 0;
  geom::dvec3 centroid{0, 0, 0};
  for (const geom::LatticePoint& p : a.points) centroid += geom::as_vector(p) / 3.0;
  contact.segment = {centroid, centroid};
  return contact;
}

// Two triangles that share an edge of their faces meet beyond it only where they are folded flat onto the same side.
bool folded_together(const FaceTriangle& a, const LatticeTriangle& ga, const FaceTriangle& b,
                     const LatticeTriangle& gb) {
  const LatticeTriangle& larger = ga.plane.normal_length >= gb.plane.normal_length ? ga : gb;
  const int dropped = geom::dominant_axis(larger.plane.normal);
  std::array<geom::PlanarPoint, 2> edge{};
  geom::PlanarPoint apex_a, apex_b;
  int found = 0;
  for (int i = 0; i < 3; ++i) {
    const geom::PlanarPoint flat = geom::project(ga.points[i], dropped);
    if (has_point(b, a.points[i])) {
      edge[found++] = flat;
    } else {
      apex_a = flat;
    }
    if (!has_point(a, b.points[i])) apex_b = geom::project(gb.points[i], dropped);
  }
  const Sign side_a = geom::orient2d(edge[0], edge[1], apex_a);
  const Sign side_b = geom::orient2d(edge[0], edge[1], apex_b);
  return side_a == side_b && side_a != Sign::Zero;
}

bool touch_in_common_edge_only(const FaceTriangle& a, const LatticeTriangle& ga, const FaceTriangle& b,
                               const LatticeTriangle& gb) {
  return in_outline(a, ga, b) && in_outline(b, gb, a) && !folded_together(a, ga, b, gb);
}

/// Examines pairs of triangles and keeps what it finds; one for each block of the search.
class PairSearch {
 public:
  PairSearch(const FaceTriangles& triangles, std::span<const TriangleColumn> columns, const geom::Tolerance& tolerance)
      : triangles_(&triangles), columns_(columns), tolerance_(tolerance.pitches) {}

  [[nodiscard]] bool full(const BlockShare& share) const {
    return pairs_ >= share.pairs || contacts.size() + vertices_on_edges.size() + near_vertices.size() >= share.contacts;
  }

  void examine(std::uint32_t i, std::uint32_t j) {
    ++pairs_;
    if (triangles_->triangles[i].face == triangles_->triangles[j].face) return;
    if (triangles_->triangles[j].points < triangles_->triangles[i].points) std::swap(i, j);
    const FaceTriangle& a = triangles_->triangles[i];
    const FaceTriangle& b = triangles_->triangles[j];
    const LatticeTriangle& ga = triangles_->geometry[i];
    const LatticeTriangle& gb = triangles_->geometry[j];
    const int shared = shared_points(a, b);
    // Where they share a diagonal of a face its outline is not what they have in common.
    const bool by_outline = shared != 2 || (in_outline(a, ga, b) && in_outline(b, gb, a));
    if (shared != 3 && by_outline && kept_apart(i, j, shared)) return;
    if (shared == 3) return keep(a.face, b.face, coincident(ga, gb));
    const Sides a_sides = geom::sides_of(ga, gb.plane, tolerance_);
    if (geom::all_on_one_side(a_sides)) return;
    const Sides b_sides = geom::sides_of(gb, ga.plane, tolerance_);
    if (geom::all_on_one_side(b_sides)) return;
    find_near_vertices(a, ga, a_sides, b, gb);
    find_near_vertices(b, gb, b_sides, a, ga);
    if (shared == 2 && touch_in_common_edge_only(a, ga, b, gb)) return;
    TriangleContact contact = geom::contact_of(ga, a_sides, gb, b_sides, tolerance_);
    if (contact.kind == ContactKind::Crossing || contact.kind == ContactKind::EdgeInFace) {
      // The outline of a face may come near on another of its triangles.
      contact.kind = geom::kind_along(contact.segment, triangles_of(a.face), triangles_of(b.face), tolerance_);
    }
    if (contact.kind != ContactKind::None) keep(a.face, b.face, contact);
  }

  std::vector<FaceContact> contacts;
  std::vector<VertexOnEdge> vertices_on_edges;
  std::vector<NearVertices> near_vertices;

 private:
  // A cheap proof that the two have nothing in common within T but what they share: by far the most pairs end here.
  [[nodiscard]] bool kept_apart(std::uint32_t i, std::uint32_t j, int shared) const {
    const auto &p = triangles_->triangles[i].points, &q = triangles_->triangles[j].points;
    geom::SharedCorners of_j{geom::kNotShared, geom::kNotShared, geom::kNotShared}, of_i = of_j;
    for (std::int8_t k = 0; k < 3 && shared > 0; ++k) {
      for (std::int8_t l = 0; l < 3; ++l) {
        if (p[k] != q[l]) continue;
        of_j[l] = k;
        of_i[k] = l;
      }
    }
    constexpr double kRounding = 1e-6;  // pitches: more than rounded distances are wrong by
    const double distance = static_cast<double>(tolerance_) + kRounding;
    // Turned from each other by less than this they may lie over each other from a common corner on.
    constexpr double kFlapCosine = 0.99;
    const double cosine = glm::dot(columns_[i].normal(), columns_[j].normal());
    const bool flaps = shared > 0 && std::abs(cosine) > kFlapCosine;
    const bool j_is_out = columns_[i].keeps_out(places(j), of_j, distance, flaps);
    if (shared == 0 && j_is_out) return true;
    return (shared == 0 || j_is_out) && columns_[j].keeps_out(places(i), of_i, distance, flaps);
  }

  [[nodiscard]] std::array<geom::dvec3, 3> places(std::uint32_t i) const {
    const auto& points = triangles_->geometry[i].points;
    return {geom::as_vector(points[0]), geom::as_vector(points[1]), geom::as_vector(points[2])};
  }

  [[nodiscard]] std::span<const LatticeTriangle> triangles_of(FaceId face) const {
    const auto before = [](const FaceTriangle& triangle, FaceId id) { return triangle.face < id; };
    const auto& all = triangles_->triangles;
    const auto first = std::lower_bound(all.begin(), all.end(), face, before);
    const auto last = std::lower_bound(first, all.end(), face + 1, before);
    return std::span(triangles_->geometry)
        .subspan(static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(last - first));
  }

  void keep(FaceId a, FaceId b, const TriangleContact& contact) {
    contacts.push_back(
        {std::min(a, b), std::max(a, b), contact.kind, contact.same_facing, contact.size, contact.segment});
  }

  void find_near_vertices(const FaceTriangle& a, const LatticeTriangle& ga, const Sides& a_sides, const FaceTriangle& b,
                          const LatticeTriangle& gb) {
    const LatticeBox reach = geom::box_of(gb.points, static_cast<std::int32_t>(tolerance_));
    for (int i = 0; i < 3; ++i) {
      if (a_sides[i] != Sign::Zero || has_point(b, a.points[i])) continue;
      if (!reach.meets(geom::box_of(std::span(&ga.points[i], 1)))) continue;
      for (int k = 0; k < 3; ++k) near_vertex(a, i, ga.points[i], b, k, gb);
    }
  }

  void near_vertex(const FaceTriangle& a, int corner, const geom::LatticePoint& vertex, const FaceTriangle& b, int edge,
                   const LatticeTriangle& gb) {
    const int next = (edge + 1) % 3;
    if (geom::points_within(vertex, gb.points[edge], tolerance_)) {
      const bool ordered = a.points[corner] < b.points[edge];
      near_vertices.push_back(ordered ? NearVertices{a.points[corner], b.points[edge], a.face, b.face}
                                      : NearVertices{b.points[edge], a.points[corner], b.face, a.face});
    }
    if (!gb.boundary[edge]) return;
    if (!geom::point_within_segment(vertex, gb.points[edge], gb.points[next], tolerance_)) return;
    if (!geom::foot_inside_segment(vertex, gb.points[edge], gb.points[next], tolerance_)) return;
    vertices_on_edges.push_back({{std::min(b.points[edge], b.points[next]), std::max(b.points[edge], b.points[next])},
                                 a.points[corner],
                                 b.face,
                                 a.face});
  }

  const FaceTriangles* triangles_;
  std::span<const TriangleColumn> columns_;  ///< per triangle
  std::int64_t tolerance_;
  std::size_t pairs_ = 0;
};

auto contact_key(const FaceContact& c) { return std::tuple(c.a, c.b, c.kind, c.same_facing); }

bool before(const FaceContact& x, const FaceContact& y) {
  if (contact_key(x) != contact_key(y)) return contact_key(x) < contact_key(y);
  if (x.size != y.size) return x.size > y.size;
  const auto flat = [](const FaceContact& c) {
    return std::array{c.segment[0].x, c.segment[0].y, c.segment[0].z, c.segment[1].x, c.segment[1].y, c.segment[1].z};
  };
  return flat(x) < flat(y);
}

// Two planar faces meet along one line: the pieces that their triangles give become the stretch from the first to the
// last.
void extend(FaceContact& whole, const FaceContact& piece) {
  const geom::dvec3 start = whole.segment[0];
  const geom::dvec3 along = whole.segment[1] - start;
  const double length = glm::length(along);
  if (length == 0) return;
  for (const geom::dvec3& end : piece.segment) {
    const double reach = glm::dot(end - start, along) / length;
    if (reach < 0 && reach < glm::dot(whole.segment[0] - start, along) / length) whole.segment[0] = end;
    if (reach > glm::dot(whole.segment[1] - start, along) / length) whole.segment[1] = end;
  }
}

// Along a diagonal of a face both of its triangles give the same stretch.
bool same_stretch(const FaceContact& x, const FaceContact& y) {
  const auto close = [](const geom::dvec3& p, const geom::dvec3& q) { return glm::distance(p, q) < 1; };
  return contact_key(x) == contact_key(y) && x.kind != ContactKind::Overlap &&
         ((close(x.segment[0], y.segment[0]) && close(x.segment[1], y.segment[1])) ||
          (close(x.segment[0], y.segment[1]) && close(x.segment[1], y.segment[0])));
}

// One contact for each pair of faces and kind.
std::vector<FaceContact> merged(std::vector<FaceContact> contacts) {
  tbb::parallel_sort(contacts.begin(), contacts.end(), before);
  std::vector<FaceContact> result;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const FaceContact& contact = contacts[i];
    if (i > 0 && same_stretch(contacts[i - 1], contact)) continue;
    if (!result.empty() && contact_key(result.back()) == contact_key(contact)) {
      result.back().size += contact.size;
      extend(result.back(), contact);
    } else {
      result.push_back(contact);
    }
  }
  return result;
}

template <typename Item>
std::vector<Item> sorted_unique(std::vector<Item> items) {
  tbb::parallel_sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  return items;
}

template <typename Item>
void append(std::vector<Item>& to, std::vector<Item>& from) {
  to.insert(to.end(), from.begin(), from.end());
  from = {};
}

}  // namespace

namespace {

// The corner with the smallest id first, as in FaceTriangles.
std::pair<FaceTriangle, LatticeTriangle> lone_face(std::array<PointId, 3> ids, std::array<geom::LatticePoint, 3> places,
                                                   FaceId face) {
  const auto first = std::min_element(ids.begin(), ids.end()) - ids.begin();
  std::rotate(ids.begin(), ids.begin() + first, ids.end());
  std::rotate(places.begin(), places.begin() + first, places.end());
  return {FaceTriangle{ids, face}, LatticeTriangle(places, {true, true, true})};
}

}  // namespace

geom::TriangleContact contact_of_lone_triangles(const std::array<PointId, 3>& a_ids,
                                                const std::array<geom::LatticePoint, 3>& a_places,
                                                const std::array<PointId, 3>& b_ids,
                                                const std::array<geom::LatticePoint, 3>& b_places,
                                                std::int64_t tolerance) {
  auto first = lone_face(a_ids, a_places, 0), second = lone_face(b_ids, b_places, 1);
  if (second.first.points < first.first.points) std::swap(first, second);
  const auto& [a, ga] = first;
  const auto& [b, gb] = second;
  const int shared = shared_points(a, b);
  if (shared == 3) return coincident(ga, gb);
  const Sides a_sides = geom::sides_of(ga, gb.plane, tolerance);
  if (geom::all_on_one_side(a_sides)) return {};
  const Sides b_sides = geom::sides_of(gb, ga.plane, tolerance);
  if (geom::all_on_one_side(b_sides)) return {};
  if (shared == 2 && touch_in_common_edge_only(a, ga, b, gb)) return {};
  return geom::contact_of(ga, a_sides, gb, b_sides, tolerance);
}

Contacts find_contacts(const FaceTriangles& triangles, const geom::Tolerance& tolerance, const SearchLimits& limits) {
  std::vector<TriangleColumn> columns(triangles.geometry.size());
  tbb::parallel_for(std::size_t{0}, columns.size(),
                    [&](std::size_t i) { columns[i] = TriangleColumn(triangles.geometry[i].points); });
  const auto shared_tree = std::make_shared<const geom::BoxTree>(inflated_boxes(triangles, tolerance));
  const geom::BoxTree& tree = *shared_tree;
  const auto slots = static_cast<std::uint32_t>(tree.size());
  const std::uint32_t block_count = (slots + kSlotsPerBlock - 1) / kSlotsPerBlock;
  const BlockShare share = share_of(limits, block_count);
  std::vector<PairSearch> blocks(block_count, PairSearch(triangles, columns, tolerance));
  tbb::parallel_for(std::uint32_t{0}, block_count, [&](std::uint32_t b) {
    const std::uint32_t end = std::min(slots, (b + 1) * kSlotsPerBlock);
    tree.for_each_later_meeting(b * kSlotsPerBlock, end, [&](std::uint32_t i, std::uint32_t j) {
      if (!blocks[b].full(share)) blocks[b].examine(i, j);
    });
  });
  PairSearch all(triangles, columns, tolerance);
  bool truncated = false;
  for (PairSearch& block : blocks) {
    truncated = truncated || block.full(share);
    append(all.contacts, block.contacts);
    append(all.vertices_on_edges, block.vertices_on_edges);
    append(all.near_vertices, block.near_vertices);
  }
  return {merged(std::move(all.contacts)), sorted_unique(std::move(all.vertices_on_edges)),
          sorted_unique(std::move(all.near_vertices)), truncated, shared_tree};
}

}  // namespace rad::validate
