#include "validate/facing.h"

#include <algorithm>
#include <map>
#include <set>

namespace rad::validate {
namespace {

using geom::Int128;

/// Areas of fronts and backs, twice and in whole pitches²: exact in any order.
struct Shown {
  Int128 fronts = 0;
  Int128 backs = 0;

  void add(const Shown& other) { fronts += other.fronts, backs += other.backs; }
  void take(const Shown& other) { fronts -= other.fronts, backs -= other.backs; }
};

// The larger part, clearly: four fifths, as a vote.
bool clearly_more(Int128 part, Int128 rest) { return part > 0 && part >= 4 * rest; }

class Facing {
 public:
  Facing(const Context& context, const LitSpace& space)
      : context_(context),
        space_(space),
        orientation_(find_orientation_sets(context)),
        state_(orientation_.sets.size()) {}

  FaceSets run() {
    look();
    find_lamps_turned_over();
    FaceSets turned_over = chosen(&State::lamp_turned_over);
    return turned_over.empty() ? chosen(&State::looks_away) : turned_over;
  }

 private:
  struct State {
    bool front_may_be_lit = false;
    bool back_lit = false;
    bool looks_away = false;
    bool lamp_turned_over = false;
  };

  [[nodiscard]] std::uint32_t set(FaceId face) const { return orientation_.set_of_face[face]; }

  [[nodiscard]] bool is_open_emitter(FaceId face) const {
    const std::uint32_t component = context_.topology.component_of_face[face];
    return context_.scene.materials[context_.material_of(face)].emits() &&
           !context_.topology.components[component].closed();
  }

  [[nodiscard]] Int128 twice_area(std::uint32_t triangle) const {
    const auto& t = space_.sheets.triangles[triangle];
    const auto& points = context_.model.points;
    return static_cast<std::int64_t>(geom::TrianglePlane(points[t[0]], points[t[1]], points[t[2]]).normal_length);
  }

  // Calls visit(triangle, cell, front, back) for both sides of every triangle.
  template <typename Visit>
  void for_each_side(Visit&& visit) const {
    for (std::uint32_t t = 0; t < space_.sheets.size(); ++t) {
      for (const int side : {0, 1}) visit(t, space_.cell(t, side), space_.sheets.front[t][side], space_.back(t, side));
    }
  }

  void look() {
    for_each_side([&](std::uint32_t, CellId cell, FaceId front, FaceId back) {
      if (front != kNoFace) state_[set(front)].front_may_be_lit |= space_.may_be_lit[cell];
      if (back != kNoFace) state_[set(back)].back_lit |= space_.lit[cell];
    });
    for (State& state : state_) state.looks_away = state.back_lit && !state.front_may_be_lit;
  }

  /// What one open set that emits has in a cell.
  using OwnInCells = std::map<CellId, Shown>;

  void find_lamps_turned_over() {
    std::map<std::uint32_t, OwnInCells> lamps;
    for (FaceId face = 0; face < context_.scene.faces.size(); ++face) {
      if (context_.is_sound(face) && is_open_emitter(face)) lamps[set(face)];
    }
    if (lamps.empty()) return;
    std::vector<Shown> in_cell(space_.cells.size());
    for_each_side([&](std::uint32_t triangle, CellId cell, FaceId front, FaceId back) {
      const Int128 area = twice_area(triangle);
      const Shown shown{front != kNoFace ? area : 0, front != kNoFace ? 0 : area};
      in_cell[cell].add(shown);
      const auto lamp = lamps.find(set(front != kNoFace ? front : back));
      if (lamp != lamps.end()) lamp->second[cell].add(shown);
    });
    for (const auto& [lamp, own] : lamps) state_[lamp].lamp_turned_over = is_turned_over(own, in_cell);
  }

  [[nodiscard]] static bool is_turned_over(const OwnInCells& own, const std::vector<Shown>& in_cell) {
    Shown before_it, behind_it;
    for (const auto& [cell, shown] : own) {
      if (shown.fronts > 0 && shown.backs > 0) return false;  // the same air on both sides
      Shown others = in_cell[cell];
      others.take(shown);
      (shown.fronts > 0 ? before_it : behind_it).add(others);
    }
    return clearly_more(before_it.backs, before_it.fronts) && clearly_more(behind_it.fronts, behind_it.backs);
  }

  [[nodiscard]] FaceSets chosen(bool State::*condition) const {
    FaceSets sets;
    for (std::size_t i = 0; i < state_.size(); ++i) {
      const OrientationSet& set = orientation_.sets[i];
      if (set.orientable && state_[i].*condition) sets.push_back(set.faces);
    }
    return sets;
  }

  const Context& context_;
  const LitSpace& space_;
  const OrientationSets orientation_;
  std::vector<State> state_;  ///< per set
};

bool box_inside(const Component& inner, const Component& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.low.z >= outer.low.z &&
         inner.high.x <= outer.high.x && inner.high.y <= outer.high.y && inner.high.z <= outer.high.z;
}

std::vector<std::uint32_t> components_that_emit(const Context& context) {
  std::set<std::uint32_t> emitting;
  for (FaceId face = 0; face < context.scene.faces.size(); ++face) {
    const std::uint32_t component = context.topology.component_of_face[face];
    if (component != kNoComponent && context.scene.materials[context.material_of(face)].emits()) {
      emitting.insert(component);
    }
  }
  return {emitting.begin(), emitting.end()};
}

}  // namespace

bool may_face_away(const Context& context) {
  const std::vector<std::uint32_t> emitting = components_that_emit(context);
  const auto& components = context.topology.components;
  return !emitting.empty() && std::ranges::any_of(components, [&](const Component& outer) {
    if (outer.open_subedges > 0) return true;
    return outer.closed() && outer.volume6 > 0 && std::ranges::any_of(emitting, [&](std::uint32_t inner) {
             return &components[inner] != &outer && box_inside(components[inner], outer);
           });
  });
}

FaceSets sets_facing_away(const Context& context, const LitSpace& space) {
  if (!space.has_emitters) return {};
  return Facing(context, space).run();
}

}  // namespace rad::validate
