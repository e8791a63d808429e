#include "repair/leader_planes.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "geom/box_tree.h"

namespace rad::repair {
namespace {

constexpr double kClaimCosine = 0.7;
constexpr ClusterId kUnclaimed = 0xffffffffu;

using geom::LatticeBox;

class Claimer {
 public:
  Claimer(const Soup& soup, double band, double proximity)
      : soup_(soup), band_(band), boxes_(boxes_of(soup, proximity)), tree_(boxes_) {
    claims_.leader_of_piece.assign(soup.pieces.size(), kUnclaimed);
    normals_.reserve(soup.pieces.size());
    for (const SoupPiece& piece : soup.pieces) normals_.push_back(soup.normal_of(piece));
  }

  PlaneClaims run() {
    for (const std::uint32_t piece : by_area()) {
      if (claims_.leader_of_piece[piece] == kUnclaimed) lead(piece);
    }
    return std::move(claims_);
  }

 private:
  static std::vector<LatticeBox> boxes_of(const Soup& soup, double proximity) {
    std::vector<LatticeBox> boxes;
    boxes.reserve(soup.pieces.size());
    std::vector<LatticePoint> corners;
    for (const SoupPiece& piece : soup.pieces) {
      corners.clear();
      for (const auto& edge : soup.edges_of(piece)) corners.push_back(soup.points[edge[0]]);
      boxes.push_back(geom::box_of(corners, static_cast<std::int32_t>(std::ceil(proximity / 2))));
    }
    return boxes;
  }

  // Largest first; equal areas in the order of their corners in space.
  [[nodiscard]] std::vector<std::uint32_t> by_area() const {
    std::vector<std::uint32_t> order(soup_.pieces.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto corners = [&](std::uint32_t piece) {
      boost::container::small_vector<LatticePoint, 3> list;
      for (const auto& edge : soup_.edges_of(soup_.pieces[piece])) list.push_back(soup_.points[edge[0]]);
      std::sort(list.begin(), list.end());
      return list;
    };
    std::vector<double> area;
    area.reserve(order.size());
    for (const dvec3& normal : normals_) area.push_back(glm::dot(normal, normal));
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
      if (area[a] != area[b]) return area[a] > area[b];
      return corners(a) < corners(b);
    });
    return order;
  }

  [[nodiscard]] bool fits(const LeaderPlane& leader, std::uint32_t piece) const {
    const double cosine = glm::dot(normals_[piece], leader.plane.normal) / glm::length(normals_[piece]);
    if (std::abs(cosine) < kClaimCosine) return false;
    return std::ranges::all_of(soup_.edges_of(soup_.pieces[piece]), [&](const auto& edge) {
      return std::abs(leader.plane.height(soup_.points[edge[0]])) <= band_;
    });
  }

  void lead(std::uint32_t first) {
    LeaderPlane leader{Plane(normals_[first], soup_.points[soup_.edges_of(soup_.pieces[first])[0][0]]), 0};
    const auto id = static_cast<ClusterId>(claims_.leaders.size());
    std::vector<std::uint32_t> open{first};
    claims_.leader_of_piece[first] = id;
    while (!open.empty()) {
      const std::uint32_t piece = open.back();
      open.pop_back();
      leader.area += glm::length(normals_[piece]) / 2;
      tree_.for_each_meeting(boxes_[piece], [&](std::uint32_t other) {
        if (claims_.leader_of_piece[other] != kUnclaimed || !fits(leader, other)) return;
        claims_.leader_of_piece[other] = id;
        open.push_back(other);
      });
    }
    claims_.leaders.push_back(leader);
  }

  const Soup& soup_;
  double band_;
  std::vector<LatticeBox> boxes_;
  geom::BoxTree tree_;
  std::vector<dvec3> normals_;
  PlaneClaims claims_;
};

}  // namespace

PlaneClaims claim_planes(const Soup& soup, double band, double proximity) {
  return Claimer(soup, band, proximity).run();
}

}  // namespace rad::repair
