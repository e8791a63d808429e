#include "repair/orientation.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "validate/rules.h"

namespace rad::repair {
namespace {

using scene::FaceId;

struct Link {
  FaceId other = 0;
  bool agrees = true;
};

// Spreads from face to face over the edges that exactly two share.
class Agreement {
 public:
  explicit Agreement(const validate::Context& context)
      : context_(context), links_(context.scene.faces.size()), side_(context.scene.faces.size(), kUnseen) {
    for (const validate::Subedge& subedge : context.topology.subedges) {
      const auto uses = context.topology.coedges_of(subedge);
      if (uses.size() != 2 || uses[0].face == uses[1].face) continue;
      const bool agrees = uses[0].forward != uses[1].forward;
      if (!agrees && lie_on_each_other(uses[0].face, uses[1].face)) continue;
      links_[uses[0].face].push_back({uses[1].face, agrees});
      links_[uses[1].face].push_back({uses[0].face, agrees});
    }
  }

  std::vector<FaceId> minority() {
    std::vector<FaceId> turn;
    for (FaceId first = 0; first < links_.size(); ++first) {
      if (side_[first] != kUnseen) continue;
      const std::vector<FaceId> members = spread(first);
      if (!consistent_) continue;
      std::array<double, 2> area{};
      for (const FaceId face : members) area[side_[face]] += glm::length(context_.triangles.normal[face]);
      const std::uint8_t smaller = area[1] > area[0] || (area[1] == area[0] && first_is_later(members)) ? 0 : 1;
      for (const FaceId face : members) {
        if (side_[face] == smaller) turn.push_back(face);
      }
    }
    std::sort(turn.begin(), turn.end());
    return turn;
  }

 private:
  static constexpr std::uint8_t kUnseen = 2;

  // Of two faces that run one way along their edge: a rug flush with its floor, not a neighbour that is turned over.
  [[nodiscard]] bool lie_on_each_other(FaceId a, FaceId b) const {
    const auto &n = context_.triangles.normal[a], &m = context_.triangles.normal[b];
    return glm::dot(n, m) >= geom::kParallelCosine * glm::length(n) * glm::length(m);
  }

  std::vector<FaceId> spread(FaceId first) {
    consistent_ = true;
    std::vector<FaceId> members{first};
    side_[first] = 0;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const FaceId face = members[next];
      for (const Link& link : links_[face]) {
        const auto side = static_cast<std::uint8_t>(link.agrees ? side_[face] : 1 - side_[face]);
        if (side_[link.other] == kUnseen) {
          side_[link.other] = side;
          members.push_back(link.other);
        } else if (side_[link.other] != side) {
          consistent_ = false;
        }
      }
    }
    return members;
  }

  // Equal halves: the one with the face that comes first in space stays.
  [[nodiscard]] bool first_is_later(const std::vector<FaceId>& members) const {
    const FaceId least =
        *std::min_element(members.begin(), members.end(), [&](FaceId a, FaceId b) { return context_.precedes(a, b); });
    return side_[least] == 1;
  }

  const validate::Context& context_;
  std::vector<std::vector<Link>> links_;
  std::vector<std::uint8_t> side_;
  bool consistent_ = true;
};

std::vector<FaceId> inside_out_faces(const validate::Context& context) {
  validate::Violations violations;
  validate::inside_out_solid.check(context, violations);
  std::vector<bool> inward(context.topology.components.size(), false);
  for (const validate::Violation& violation : violations.items) {
    inward[context.topology.component_of_face[violation.faces[0]]] = true;
  }
  std::vector<FaceId> faces;
  for (FaceId face = 0; face < context.scene.faces.size(); ++face) {
    const std::uint32_t component = context.topology.component_of_face[face];
    if (component != validate::kNoComponent && inward[component]) faces.push_back(face);
  }
  return faces;
}

}  // namespace

std::vector<FaceId> faces_to_turn(const validate::Context& context) {
  std::vector<FaceId> turn = Agreement(context).minority();
  return turn.empty() ? inside_out_faces(context) : turn;
}

scene::Scene turned(scene::Scene scene, const std::vector<FaceId>& faces) {
  for (const FaceId face : faces) {
    for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
      if (loop.count > 1)
        std::reverse(scene.corners.begin() + loop.first + 1, scene.corners.begin() + loop.first + loop.count);
    }
  }
  return scene;
}

std::vector<FaceId> orient(scene::Scene& scene, const scene::ReadIssues& issues,
                           const std::optional<geom::ToleranceRequest>& tolerance) {
  std::vector<FaceId> all;
  // First neighbours, then whole objects; turning an object may make another one a room.
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    std::string refusal;
    const auto context = validate::build_context(scene, issues, tolerance, refusal);
    if (!context) break;
    const std::vector<FaceId> turn = faces_to_turn(*context);
    if (turn.empty()) break;
    std::vector<FaceId> both;
    std::set_symmetric_difference(all.begin(), all.end(), turn.begin(), turn.end(), std::back_inserter(both));
    all = std::move(both);
    scene = turned(std::move(scene), turn);
  }
  return all;
}

}  // namespace rad::repair
