#include "repair/triangulation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>

#include "repair/cluster_map.h"

namespace rad::repair {
namespace {

// Whether the points run from the smallest to the larger of the two others: tells the two facings apart.
bool runs_up(const std::array<PointId, 3>& points) {
  const auto least = static_cast<std::size_t>(std::min_element(points.begin(), points.end()) - points.begin());
  return points[(least + 1) % 3] < points[(least + 2) % 3];
}

// The piece of one facing that wins: the least rank, then the least id.
const PieceId* winner(const Complex& complex, const std::vector<PieceId>& cover, bool along) {
  const PieceId* best = nullptr;
  for (const PieceId& id : cover) {
    if (complex.pieces()[id].along != along) continue;
    if (!best || complex.pieces()[id].rank < complex.pieces()[*best].rank) best = &id;
  }
  return best;
}

}  // namespace

Triangulation::ClusterPart Triangulation::triangulate(const Complex& complex, ClusterId cluster) {
  ClusterPart part;
  part.version = complex.clusters()[cluster].version;
  ClusterMap map(complex, cluster);
  part.stacking = map.stacking();
  part.sound = part.stacking.points.empty() && part.stacking.points_on_edges.empty() && !part.stacking.crossing;
  map.flip_slivers(complex.tolerance());
  part.covers = map.covers();
  for (std::size_t i = 0; i < map.triangles().size(); ++i) {
    const std::uint32_t cover = map.cover(i);
    for (const bool along : {true, false}) {
      const PieceId* best = winner(complex, part.covers[cover], along);
      if (!best) continue;
      std::array<PointId, 3> points = map.points(i);
      if (!along) std::swap(points[1], points[2]);
      part.triangles.push_back({points, cluster, along, *best, cover});
    }
  }
  return part;
}

void Triangulation::update(const Complex& complex) {
  const auto clusters = complex.clusters();
  clusters_.resize(clusters.size());
  std::vector<ClusterId> changed;
  for (ClusterId id = 0; id < clusters.size(); ++id) {
    if (clusters_[id].version != clusters[id].version) changed.push_back(id);
  }
  tbb::parallel_for(std::size_t{0}, changed.size(),
                    [&](std::size_t i) { clusters_[changed[i]] = triangulate(complex, changed[i]); });
  triangles_.clear();
  stacking_ = {};
  folded_ = std::make_unique<bool[]>(clusters_.size());
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    const ClusterPart& part = clusters_[i];
    folded_[i] = !part.sound;
    triangles_.insert(triangles_.end(), part.triangles.begin(), part.triangles.end());
    const Stacking& own = part.stacking;
    stacking_.points.insert(stacking_.points.end(), own.points.begin(), own.points.end());
    stacking_.points_on_edges.insert(stacking_.points_on_edges.end(), own.points_on_edges.begin(),
                                     own.points_on_edges.end());
    stacking_.crossing |= own.crossing;
  }
  drop_doubles(complex);
}

void Triangulation::drop_doubles(const Complex& complex) {
  std::vector<std::pair<std::array<PointId, 4>, std::uint32_t>> keys;
  keys.reserve(triangles_.size());
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    std::array<PointId, 3> sorted = triangles_[i].points;
    const PointId facing = runs_up(sorted) ? 1 : 0;
    std::sort(sorted.begin(), sorted.end());
    keys.push_back({{sorted[0], sorted[1], sorted[2], facing}, i});
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> dropped(triangles_.size(), false);
  const auto area = [&](std::uint32_t i) { return complex.clusters()[triangles_[i].cluster].area; };
  for (std::size_t i = 1, kept = 0; i < keys.size(); ++i) {
    if (keys[i].first != keys[kept].first) {
      kept = i;
      continue;
    }
    const bool smaller = area(keys[i].second) < area(keys[kept].second);
    dropped[smaller ? keys[kept].second : keys[i].second] = true;
    if (smaller) kept = i;
  }
  std::uint32_t index = 0;
  std::erase_if(triangles_, [&](const Triangle&) { return dropped[index++]; });
}

}  // namespace rad::repair
