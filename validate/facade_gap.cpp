#include "validate/facade_gap.h"

#include <algorithm>
#include <tuple>

#include "geom/segment_distance.h"

namespace rad::validate {
namespace {

geom::BoxTree tree_of(const Context& context) {
  std::vector<geom::LatticeBox> boxes;
  boxes.reserve(context.triangles.geometry.size());
  for (const geom::LatticeTriangle& triangle : context.triangles.geometry)
    boxes.push_back(geom::box_of(triangle.points));
  return geom::BoxTree(std::move(boxes));
}

bool before(const Gap& a, const Gap& b) {
  const auto key = [](const Gap& gap) { return std::tuple(gap.width, gap.middle.x, gap.middle.y, gap.middle.z); };
  return key(a) < key(b);
}

}  // namespace

FacadeGaps::FacadeGaps(const Context& context)
    : context_(context), tree_(tree_of(context)), rims_(context.topology.components.size()) {
  for (std::uint32_t i = 0; i < context.topology.subedges.size(); ++i) {
    const auto coedges = context.topology.coedges_of(context.topology.subedges[i]);
    if (coedges.size() == 1) rims_[context.topology.component_of_face[coedges[0].face]].push_back(i);
  }
}

std::optional<Gap> FacadeGaps::narrowest(std::uint32_t component) const {
  std::optional<Gap> best;
  for (const std::uint32_t subedge : rims_[component]) measure(context_.topology.subedges[subedge], best);
  return best;
}

void FacadeGaps::measure(const Subedge& subedge, std::optional<Gap>& best) const {
  const auto reach = static_cast<double>(kGapReach * context_.tolerance.pitches);
  const auto& points = context_.model.points;
  const geom::Segment rim{geom::as_vector(points[subedge.a]), geom::as_vector(points[subedge.b])};
  tree_.for_each_near_segment(rim[0], rim[1], reach, [&](std::uint32_t id) {
    const FaceTriangle& triangle = context_.triangles.triangles[id];
    const auto touches = [&](PointId p) { return p == subedge.a || p == subedge.b; };
    if (std::ranges::any_of(triangle.points, touches)) return;
    std::array<dvec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = geom::as_vector(context_.triangles.geometry[id].points[i]);
    const geom::Segment way = geom::shortest_between(rim, corners);
    const Gap gap{(way[0] + way[1]) * 0.5, geom::length(way)};
    if (gap.width <= reach && (!best || before(gap, *best))) best = gap;
  });
}

}  // namespace rad::validate
