#include "repair/plane_groups.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "repair/edge_uses.h"

namespace rad::repair {
namespace {

constexpr double kBand = 0.5;          // T
constexpr double kBandOfClusters = 1;  // T: what repair has put into a plane may have been drawn off it
constexpr double kFacingCosine = 0.7;

class Grouper {
 public:
  Grouper(PlanarTriangles& set, double tolerance)
      : set_(set), uses_(set), tolerance_(tolerance), had_cluster_(set.members.size()) {
    normals_.reserve(set.members.size());
    for (std::size_t i = 0; i < set.members.size(); ++i) {
      const auto& ids = set.members[i].points;
      const dvec3 a = place(ids[0]), b = place(ids[1]), c = place(ids[2]);
      normals_.push_back(glm::cross(b - a, c - a));
      had_cluster_[i] = set.members[i].cluster != kNoCluster ? 1 : 0;
      set.members[i].cluster = kNoCluster;
    }
    set.planes.clear();
  }

  void run() {
    for (const std::uint32_t first : by_area()) {
      if (set_.members[first].cluster == kNoCluster) lead(first);
    }
  }

 private:
  [[nodiscard]] dvec3 place(PointId id) const { return geom::as_vector(set_.points[id]); }

  // Largest first; equal ones in the order of their corners in space.
  [[nodiscard]] std::vector<std::uint32_t> by_area() const {
    std::vector<std::uint32_t> order(set_.members.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<double> area;
    area.reserve(order.size());
    for (const dvec3& normal : normals_) area.push_back(glm::dot(normal, normal));
    const auto corners = [&](std::uint32_t i) {
      const auto& ids = set_.members[i].points;
      return std::array{set_.points[ids[0]], set_.points[ids[1]], set_.points[ids[2]]};
    };
    tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      if (area[a] != area[b]) return area[a] > area[b];
      auto of_a = corners(a), of_b = corners(b);
      std::sort(of_a.begin(), of_a.end());
      std::sort(of_b.begin(), of_b.end());
      return of_a != of_b ? of_a < of_b : corners(a) < corners(b);
    });
    return order;
  }

  [[nodiscard]] bool fits(const Plane& plane, std::uint32_t i) const {
    const double along = glm::dot(normals_[i], plane.normal);
    if (along * along < kFacingCosine * kFacingCosine * glm::dot(normals_[i], normals_[i])) return false;
    const double band = (had_cluster_[i] ? kBandOfClusters : kBand) * tolerance_;
    return std::ranges::all_of(set_.members[i].points,
                               [&](PointId id) { return std::abs(plane.height(set_.points[id])) <= band; });
  }

  void lead(std::uint32_t first) {
    const Plane plane(normals_[first], set_.points[set_.members[first].points[0]]);
    const auto id = static_cast<ClusterId>(set_.planes.size());
    set_.planes.push_back(plane);
    std::vector<std::uint32_t> open{first};
    set_.members[first].cluster = id;
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      set_.members[i].along = glm::dot(normals_[i], plane.normal) > 0;
      const auto& ids = set_.members[i].points;
      for (std::size_t k = 0; k < 3; ++k) {
        for (const Side side : uses_.between(ids[k], ids[(k + 1) % 3])) {
          const std::uint32_t other = side / 3;
          if (set_.members[other].cluster != kNoCluster || !fits(plane, other)) continue;
          set_.members[other].cluster = id;
          open.push_back(other);
        }
      }
    }
  }

  PlanarTriangles& set_;
  const EdgeUses uses_;
  double tolerance_;
  std::vector<std::uint8_t> had_cluster_;
  std::vector<dvec3> normals_;
};

}  // namespace

void group_by_planes(PlanarTriangles& set, double tolerance) { Grouper(set, tolerance).run(); }

}  // namespace rad::repair
