#include "repair/input_soup.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "repair/rings_in_space.h"

namespace rad::repair {
namespace {

using validate::FaceCondition;

struct Draft {
  std::vector<std::array<PointId, 2>> edges;
  scene::FaceId source = 0;
  std::uint32_t rank = 0;
};

Draft of_triangle(const validate::FaceTriangle& triangle, std::uint32_t rank) {
  const auto& [a, b, c] = triangle.points;
  return {{{a, b}, {b, c}, {c, a}}, triangle.face, rank};
}

Draft of_rings(const validate::Context& context, scene::FaceId face, std::uint32_t rank) {
  Draft draft{{}, face, rank};
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
    const auto corners = context.model.corners_of(loop);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const PointId next = corners[(i + 1) % corners.size()];
      if (corners[i] != next) draft.edges.push_back({corners[i], next});
    }
  }
  return draft;
}

// The triangles of a ring that passes itself in space, though it crosses in its plane; nothing for any other face.
std::vector<Draft> in_space(const validate::Context& context, scene::FaceId face, std::uint32_t rank) {
  const auto loops = context.scene.loops_of(context.scene.faces[face]);
  if (loops.size() != 1 || loops[0].count > kMostCornersInSpace) return {};
  const auto corners = context.model.corners_of(loops[0]);
  std::vector<geom::LatticePoint> ring;
  for (const PointId corner : corners) ring.push_back(context.model.points[corner]);
  if (meets_itself(ring, context.tolerance.pitches)) return {};
  std::vector<Draft> drafts;
  for (const auto& [i, j, k] : least_area_triangles(ring)) {
    if (geom::collinear(ring[i], ring[j], ring[k])) continue;
    std::array points{corners[i], corners[j], corners[k]};
    std::ranges::rotate(points, std::ranges::min_element(points));
    drafts.push_back(of_triangle({points, face}, rank));
  }
  return drafts;
}

std::vector<Draft> drafts_of(const validate::Context& context, std::span<const std::uint32_t> ranks) {
  std::vector<Draft> drafts;
  drafts.reserve(context.triangles.triangles.size());
  for (const auto& triangle : context.triangles.triangles) {
    drafts.push_back(of_triangle(triangle, ranks[triangle.face]));
  }
  for (scene::FaceId face = 0; face < context.scene.faces.size(); ++face) {
    if (context.triangles.condition[face] != FaceCondition::RingCrosses) continue;
    std::vector<Draft> triangles = in_space(context, face, ranks[face]);
    if (triangles.empty()) triangles.push_back(of_rings(context, face, ranks[face]));
    std::ranges::move(triangles, std::back_inserter(drafts));
  }
  // Point ids follow the places of points, so this is an order of space.
  std::sort(drafts.begin(), drafts.end(), [](const Draft& a, const Draft& b) {
    return std::tie(a.edges, a.rank, a.source) < std::tie(b.edges, b.rank, b.source);
  });
  return drafts;
}

}  // namespace

Soup input_soup(const validate::Context& context, std::span<const std::uint32_t> ranks) {
  Soup soup;
  soup.points = context.model.points;
  for (const Draft& draft : drafts_of(context, ranks)) {
    soup.pieces.push_back({static_cast<std::uint32_t>(soup.edges.size()),
                           static_cast<std::uint32_t>(draft.edges.size()), draft.source, draft.rank});
    soup.edges.insert(soup.edges.end(), draft.edges.begin(), draft.edges.end());
  }
  return soup;
}

}  // namespace rad::repair
