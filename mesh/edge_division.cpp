#include "mesh/edge_division.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "mesh/edge_sizes.h"
#include "mesh/lengths.h"
#include "mesh/spaced_points.h"

namespace rad::mesh {
namespace {

using geom::as_vector;
using geom::dvec3;
using geom::LatticePoint;

double length_of(const LatticePoint& a, const LatticePoint& b) { return glm::length(as_vector(b) - as_vector(a)); }

LatticePoint rounded(const dvec3& p) {
  return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y)),
          static_cast<std::int32_t>(std::lround(p.z))};
}

// How many parts of at most `longest`, unless they would be shorter than `spacing`.
std::uint32_t parts_of(double length, double longest, std::uint32_t least, double spacing) {
  const double wanted = std::max(std::ceil((length - kLengthRounding) / longest), static_cast<double>(least));
  return static_cast<std::uint32_t>(std::max(1.0, std::min(wanted, std::floor(length / spacing))));
}

std::vector<double> equal_places(double from, double to, std::uint32_t parts) {
  std::vector<double> places;
  for (std::uint32_t k = 0; k <= parts; ++k) places.push_back(from + (to - from) * k / parts);
  return places;
}

// An end of an edge, for finding the edges that leave a point at a small angle.
struct EdgeEnd {
  PointId point;
  std::uint32_t edge;
  std::uint32_t end;
  dvec3 direction;
};

}  // namespace

EdgeDivision::EdgeDivision(const scene::ConformingModel& model, std::span<const double> longest_of_face,
                           std::span<const EdgeKey> halved, std::span<const EdgeKey> whole, const EdgeSizes& sizes,
                           std::span<const std::vector<SharpEdge>> sharp_of_face)
    : points_(model.points) {
  const double spacing = least_spacing(model.tolerance);
  collect(model, longest_of_face);
  find_reaches(spacing);
  widen_reaches(model, sharp_of_face);
  SpacedPoints taken(spacing);
  for (const LatticePoint& point : points_) taken.add(point);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    Edge& edge = edges_[e];
    edge.first = static_cast<PointId>(points_.size());
    if (std::binary_search(whole.begin(), whole.end(), edge.ends)) continue;
    const bool halve = std::binary_search(halved.begin(), halved.end(), edge.ends);
    const dvec3 from = as_vector(points_[edge.ends[0]]), to = as_vector(points_[edge.ends[1]]);
    const std::span<const SizedPlace> wanted = sizes.empty() ? std::span<const SizedPlace>{} : sizes.of(e);
    for (const double share : places(edge, wanted, halve ? 2 : 1, spacing)) {
      const LatticePoint point = rounded(from + (to - from) * share);
      if (taken.add_if_spaced(point)) points_.push_back(point);
    }
    edge.count = static_cast<std::uint32_t>(points_.size()) - edge.first;
  }
}

void EdgeDivision::collect(const scene::ConformingModel& model, std::span<const double> longest_of_face) {
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const auto add = [&](PointId a, PointId b) { edges_.push_back({key(a, b), longest_of_face[f]}); };
    for (const scene::Loop& loop : model.loops_of(model.faces[f])) {
      const auto ring = model.corners_of(loop);
      for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (const auto& edge : model.inner_edges_of(model.faces[f])) add(edge[0], edge[1]);
  }
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& a, const Edge& b) { return a.ends != b.ends ? a.ends < b.ends : a.longest < b.longest; });
  const auto same = [](const Edge& a, const Edge& b) { return a.ends == b.ends; };
  edges_.erase(std::unique(edges_.begin(), edges_.end(), same), edges_.end());
}

void EdgeDivision::find_reaches(double spacing) {
  std::vector<EdgeEnd> ends;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const EdgeKey& key = edges_[e].ends;
    const dvec3 way = glm::normalize(as_vector(points_[key[1]]) - as_vector(points_[key[0]]));
    ends.push_back({key[0], e, 0, way});
    ends.push_back({key[1], e, 1, -way});
  }
  std::sort(ends.begin(), ends.end(), [](const EdgeEnd& a, const EdgeEnd& b) {
    return a.point != b.point ? a.point < b.point : a.edge < b.edge;
  });
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size() && ends[j].point == ends[i].point; ++j) {
      const double reach = reach_apart(ends[i].direction, ends[j].direction, spacing);
      for (const EdgeEnd& end : {ends[i], ends[j]}) {
        double& known = edges_[end.edge].reach[end.end];
        known = std::max(known, reach);
      }
    }
  }
}

// Where one of two edges of a loop in a row is sharp the other keeps its distance from it.
void EdgeDivision::widen_reaches(const scene::ConformingModel& model,
                                 std::span<const std::vector<SharpEdge>> sharp_of_face) {
  for (std::size_t f = 0; f < sharp_of_face.size(); ++f) {
    std::map<EdgeKey, double> clearance;
    for (const SharpEdge& sharp : sharp_of_face[f]) {
      double& known = clearance[key(sharp.ends[0], sharp.ends[1])];
      known = std::max(known, sharp.clearance);
    }
    if (clearance.empty()) continue;
    for (const scene::Loop& loop : model.loops_of(model.faces[f])) {
      const auto ring = model.corners_of(loop);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const PointId before = ring[i], at = ring[(i + 1) % ring.size()], after = ring[(i + 2) % ring.size()];
        if (const auto own = clearance.find(key(before, at)); own != clearance.end()) {
          widen_reach({at, after}, before, own->second);
        }
        if (const auto own = clearance.find(key(at, after)); own != clearance.end()) {
          widen_reach({at, before}, after, own->second);
        }
      }
    }
  }
}

// Of the edge from edge[0] at that end, against the edge from there to `along`.
void EdgeDivision::widen_reach(const std::array<PointId, 2>& edge, PointId along, double clearance) {
  const dvec3 from = as_vector(points_[edge[0]]);
  const dvec3 way = glm::normalize(as_vector(points_[edge[1]]) - from);
  const dvec3 other = glm::normalize(as_vector(points_[along]) - from);
  const double sine = glm::dot(way, other) > 0 ? glm::length(glm::cross(way, other)) : 1;
  const EdgeKey ends = key(edge[0], edge[1]);
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), ends, [](const Edge& e, const EdgeKey& k) { return e.ends < k; });
  double& reach = found->reach[found->ends[0] == edge[0] ? 0 : 1];
  reach = std::max(reach, clearance / sine);
}

// Shares of the edge at which it is divided, ascending. Where a needle tip must stay undivided, the rest is divided
// from the tip's end on.
std::vector<double> EdgeDivision::places(const Edge& edge, std::span<const SizedPlace> sizes, std::uint32_t least_parts,
                                         double spacing) const {
  const double length = length_of(points_[edge.ends[0]], points_[edge.ends[1]]);
  const double step = length / parts_of(length, edge.longest, least_parts, spacing);
  const double from = edge.reach[0] > step ? edge.reach[0] : 0;
  const double to = edge.reach[1] > step ? length - edge.reach[1] : length;
  std::vector<double> shares;
  if (from >= to) return shares;
  const std::uint32_t parts = from == 0 && to == length ? least_parts : 1;
  const double least_from = std::max(edge.reach[0], spacing), least_to = std::max(edge.reach[1], spacing);
  const bool graded =
      std::any_of(sizes.begin(), sizes.end(), [&](const SizedPlace& s) { return s.size < edge.longest; });
  for (const double place : graded ? graded_places(sizes, from, to, edge.longest, parts, spacing)
                                   : equal_places(from, to, parts_of(to - from, edge.longest, parts, spacing))) {
    if (place >= least_from && length - place >= least_to) shares.push_back(place / length);
  }
  return shares;
}

void EdgeDivision::chain_of(std::size_t edge, std::vector<PointId>& chain) const {
  chain.clear();
  chain.push_back(edges_[edge].ends[0]);
  for (std::uint32_t k = 0; k < edges_[edge].count; ++k) chain.push_back(edges_[edge].first + k);
  chain.push_back(edges_[edge].ends[1]);
}

std::size_t EdgeDivision::edge_of(PointId point) const {
  const auto after =
      std::upper_bound(edges_.begin(), edges_.end(), point, [](PointId p, const Edge& edge) { return p < edge.first; });
  return static_cast<std::size_t>(after - edges_.begin()) - 1;
}

void EdgeDivision::append_chain(PointId from, PointId to, std::vector<PointId>& chain) const {
  const EdgeKey ends = key(from, to);
  const auto edge =
      std::lower_bound(edges_.begin(), edges_.end(), ends, [](const Edge& e, const EdgeKey& k) { return e.ends < k; });
  chain.push_back(from);
  for (std::uint32_t k = 0; k < edge->count; ++k) {
    chain.push_back(edge->first + (ends[0] == from ? k : edge->count - 1 - k));
  }
}

}  // namespace rad::mesh
