#include "mesh/node_sectors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace rad::mesh {
namespace {

// The corners counter-clockwise from the border of the sector on; empty where they close around the node.
std::vector<NodeCorner> fan_of(std::span<const NodeCorner> corners) {
  std::vector<NodeCorner> by_next(corners.begin(), corners.end());
  const auto less = [](const NodeCorner& a, const NodeCorner& b) { return a.next < b.next; };
  std::sort(by_next.begin(), by_next.end(), less);
  std::vector<NodeId> ends;
  for (const NodeCorner& corner : corners) ends.push_back(corner.previous);
  std::sort(ends.begin(), ends.end());
  const auto start = std::find_if(by_next.begin(), by_next.end(), [&](const NodeCorner& corner) {
    return !std::binary_search(ends.begin(), ends.end(), corner.next);
  });
  std::vector<NodeCorner> fan;
  for (auto corner = start; corner != by_next.end() && fan.size() < corners.size();) {
    fan.push_back(*corner);
    NodeCorner sought;
    sought.next = corner->previous;
    corner = std::lower_bound(by_next.begin(), by_next.end(), sought, less);
    if (corner != by_next.end() && corner->next != sought.next) break;
  }
  return fan;
}

}  // namespace

dvec3 SectorView::unit_way(NodeId from, NodeId to) const {
  return glm::normalize(nodes_[to].position - nodes_[from].position);
}

double SectorView::angle(NodeId node, const NodeCorner& corner) const {
  const dvec3 a = unit_way(node, corner.next), b = unit_way(node, corner.previous);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

dvec3 SectorView::normal(std::span<const NodeCorner> corners) const {
  const dvec3 first = mesh_.source(corners.front().patch).normal;
  const bool agree = std::all_of(corners.begin(), corners.end(),
                                 [&](const NodeCorner& corner) { return mesh_.source(corner.patch).normal == first; });
  if (agree) return first;
  std::vector<PatchSource> faces;
  for (const NodeCorner& corner : corners) faces.push_back(mesh_.source(corner.patch));
  std::sort(faces.begin(), faces.end(), [](const PatchSource& a, const PatchSource& b) { return a.face < b.face; });
  const auto same_face = [](const PatchSource& a, const PatchSource& b) { return a.face == b.face; };
  faces.erase(std::unique(faces.begin(), faces.end(), same_face), faces.end());
  dvec3 sum(0, 0, 0);
  for (const PatchSource& face : faces) sum += face.normal * face.face_area;
  return glm::normalize(sum);
}

dvec3 SectorView::inward(NodeId node, std::span<const NodeCorner> corners) const {
  const std::vector<NodeCorner> fan = fan_of(corners);
  if (fan.empty()) return {0, 0, 0};
  double half = 0;
  for (const NodeCorner& corner : fan) half += angle(node, corner) / 2;
  std::size_t at = 0;
  while (at + 1 < fan.size() && half > angle(node, fan[at])) half -= angle(node, fan[at++]);
  const dvec3 from = unit_way(node, fan[at].next);
  // In the plane of one face, not in that of the mean normal: where faces rise from the node, a step in the latter ends
  // behind them.
  return from * std::cos(half) + glm::cross(mesh_.source(fan[at].patch).normal, from) * std::sin(half);
}

}  // namespace rad::mesh
