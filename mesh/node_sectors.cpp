#include "mesh/node_sectors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rad::mesh {
namespace {

dvec3 unit_way(const NodeCorner& corner, NodeId to, std::span<const Node> nodes) {
  return glm::normalize(nodes[to].position - nodes[corner.node].position);
}

double angle_of(const NodeCorner& corner, std::span<const Node> nodes) {
  const dvec3 a = unit_way(corner, corner.next, nodes), b = unit_way(corner, corner.previous, nodes);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

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

dvec3 node_normal(std::span<const NodeCorner> corners) {
  std::vector<NodeCorner> faces(corners.begin(), corners.end());
  std::sort(faces.begin(), faces.end(), [](const NodeCorner& a, const NodeCorner& b) { return a.face < b.face; });
  const auto same_face = [](const NodeCorner& a, const NodeCorner& b) { return a.face == b.face; };
  faces.erase(std::unique(faces.begin(), faces.end(), same_face), faces.end());
  const dvec3 first = faces.front().normal;
  if (std::all_of(faces.begin(), faces.end(), [&](const NodeCorner& face) { return face.normal == first; })) return first;
  dvec3 sum(0, 0, 0);
  for (const NodeCorner& face : faces) sum += face.normal * face.face_area;
  return glm::normalize(sum);
}

dvec3 inward_direction(std::span<const NodeCorner> corners, const dvec3& normal, std::span<const Node> nodes) {
  const std::vector<NodeCorner> fan = fan_of(corners);
  if (fan.empty()) return {0, 0, 0};
  double half = 0;
  for (const NodeCorner& corner : fan) half += angle_of(corner, nodes) / 2;
  std::size_t at = 0;
  while (at + 1 < fan.size() && half > angle_of(fan[at], nodes)) half -= angle_of(fan[at++], nodes);
  const dvec3 from = unit_way(fan[at], fan[at].next, nodes);
  const dvec3 way = from * std::cos(half) + glm::cross(fan[at].normal, from) * std::sin(half);
  return glm::normalize(way - normal * glm::dot(way, normal));
}

}  // namespace rad::mesh
