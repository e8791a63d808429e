#include "scene/near_distances.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "geom/auto_tolerance.h"
#include "geom/box_tree.h"

namespace rad::scene {
namespace {

// Both ends of a distance are rounded by up to a pitch.
constexpr double kRoundedPitches = 2;

using Edge = std::array<PointId, 2>;

std::vector<Edge> edges_of(const Scene& scene, const LatticeModel& model) {
  std::vector<Edge> edges;
  edges.reserve(model.corners.size());
  for (FaceId face = 0; face < scene.faces.size(); ++face) {
    if (model.left_out[face]) continue;
    for (const Loop& loop : scene.loops_of(scene.faces[face])) {
      const auto corners = model.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId a = corners[i], b = corners[(i + 1) % corners.size()];
        if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
      }
    }
  }
  tbb::parallel_sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

class NearSearch {
 public:
  NearSearch(const Scene& scene, const LatticeModel& model)
      : model_(model),
        edges_(edges_of(scene, model)),
        tree_(boxes()),
        reach_(model.points.size(), geom::kAutoReach * model.box.diagonal() / model.lattice.pitch) {
    // The shortest edge at a vertex bounds both distances, so the search need not go farther.
    for (const Edge& edge : edges_) {
      const double length = glm::distance(place(edge[0]), place(edge[1]));
      for (const PointId end : edge) reach_[end] = std::min(reach_[end], length);
    }
  }

  // To the nearest vertex and to the nearest edge, in pitches; beyond the reach where there is none.
  [[nodiscard]] std::array<double, 2> distances(PointId point) const {
    const dvec3 here = place(point);
    std::array<double, 2> least{INFINITY, INFINITY};
    const auto cube = geom::box_of(std::span(&model_.points[point], 1), static_cast<std::int32_t>(reach_[point]) + 1);
    tree_.for_each_meeting(cube, [&](std::uint32_t id) {
      const Edge& edge = edges_[id];
      for (const PointId end : edge) {
        if (end != point) least[0] = std::min(least[0], glm::distance(here, place(end)));
      }
      if (edge[0] == point || edge[1] == point) return;
      least[1] = std::min(least[1], geom::distance_to_segment(here, place(edge[0]), place(edge[1])));
    });
    return least;
  }

  [[nodiscard]] double reach(PointId point) const { return reach_[point]; }

 private:
  [[nodiscard]] dvec3 place(PointId id) const { return geom::as_vector(model_.points[id]); }

  [[nodiscard]] std::vector<geom::LatticeBox> boxes() const {
    std::vector<geom::LatticeBox> boxes;
    boxes.reserve(edges_.size());
    for (const Edge& edge : edges_) {
      const std::array ends{model_.points[edge[0]], model_.points[edge[1]]};
      boxes.push_back(geom::box_of(ends));
    }
    return boxes;
  }

  const LatticeModel& model_;
  std::vector<Edge> edges_;
  geom::BoxTree tree_;
  std::vector<double> reach_;  ///< per point, pitches
};

}  // namespace

std::vector<double> near_distances(const Scene& scene, const LatticeModel& model) {
  const NearSearch search(scene, model);
  std::vector<std::array<double, 2>> found(model.points.size());
  tbb::parallel_for(std::size_t{0}, found.size(),
                    [&](std::size_t i) { found[i] = search.distances(static_cast<PointId>(i)); });
  std::vector<double> distances;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const double distance : found[i]) {
      const bool seen = distance > kRoundedPitches && distance <= search.reach(static_cast<PointId>(i));
      if (seen) distances.push_back(distance * model.lattice.pitch);
    }
  }
  tbb::parallel_sort(distances.begin(), distances.end());
  return distances;
}

}  // namespace rad::scene
