#include "repair/coplanar_log.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <string_view>

namespace rad::repair {
namespace {

using Place = std::array<double, 3>;

Place flat(const dvec3& p) { return {p.x, p.y, p.z}; }

/// Names of both sides and the reason: what removals are put together by.
using Names = std::tuple<std::string_view, std::string_view, std::string_view, std::string_view, OrderRule>;

scene::CoplanarRemoval::Side side_of(const scene::Scene& input, scene::FaceId face) {
  return {input.objects[input.faces[face].object], input.materials[input.faces[face].material].name,
          scene::reference_to(input, face)};
}

}  // namespace

void CoplanarLog::add(std::span<const CoveredCell> cells, const SurfaceOrder& order,
                      std::span<const scene::FaceId> origin) {
  const auto of_input = [&](scene::FaceId face) { return origin.empty() ? face : origin[face]; };
  if (gave_way_.empty()) gave_way_.assign(order.ranks().size(), false);
  for (const CoveredCell& cell : cells) {
    const scene::FaceId winner = of_input(cell.winner), loser = of_input(cell.loser);
    gave_way_[loser] = true;
    Sum& sum = sums_[{winner, loser, order.decided_by(winner, loser)}];
    ++sum.count;
    sum.area += cell.area;
    const bool larger =
        cell.area != sum.largest_cell ? cell.area > sum.largest_cell : flat(cell.middle) < flat(sum.middle);
    if (!larger) continue;
    sum.largest_cell = cell.area;
    sum.middle = cell.middle;
  }
}

scene::CoplanarRemovals CoplanarLog::removals(const scene::Scene& input, const geom::Lattice& lattice) const {
  std::map<Names, std::vector<const std::pair<const Pair, Sum>*>> groups;
  for (const auto& entry : sums_) {
    const auto& [winner, loser, rule] = entry.first;
    const scene::Face &a = input.faces[winner], &b = input.faces[loser];
    groups[{input.objects[a.object], input.materials[a.material].name, input.objects[b.object],
            input.materials[b.material].name, rule}]
        .push_back(&entry);
  }
  scene::CoplanarRemovals result;
  for (auto& [names, members] : groups) {
    std::ranges::sort(members, [](const auto* x, const auto* y) {
      if (x->second.largest_cell != y->second.largest_cell) return x->second.largest_cell > y->second.largest_cell;
      return std::tuple(flat(x->second.middle), x->second.area) < std::tuple(flat(y->second.middle), y->second.area);
    });
    const auto& [pair, largest] = *members.front();
    scene::CoplanarRemoval removal{side_of(input, std::get<0>(pair)), side_of(input, std::get<1>(pair))};
    removal.rule = static_cast<char>(std::get<2>(pair));
    removal.tie = std::get<2>(pair) == OrderRule::Content;
    removal.point = lattice.origin + lattice.pitch * largest.middle;
    for (const auto* member : members) {
      removal.count += member->second.count;
      removal.area += member->second.area * lattice.pitch * lattice.pitch;
    }
    result.push_back(std::move(removal));
  }
  std::ranges::stable_sort(result, [](const auto& x, const auto& y) { return x.area > y.area; });
  return result;
}

bool CoplanarLog::gave_way(scene::FaceId face) const { return face < gave_way_.size() && gave_way_[face]; }

}  // namespace rad::repair
