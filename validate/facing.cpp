#include "validate/facing.h"

#include <algorithm>

namespace rad::validate {
namespace {

constexpr std::uint32_t kNobody = 0xffffffffu, kSeveral = 0xfffffffeu;

/// Who shows a front or a back in a cell: nobody, one set, or several.
struct Watchers {
  std::uint32_t fronts = kNobody;
  std::uint32_t backs = kNobody;
};

void note(std::uint32_t& who, std::uint32_t set) { who = who == kNobody || who == set ? set : kSeveral; }

bool nobody_but(std::uint32_t who, std::uint32_t set) { return who == kNobody || who == set; }

class Facing {
 public:
  Facing(const Context& context, const LitSpace& space, const OrientationSets& orientation)
      : context_(context), space_(space), orientation_(orientation), state_(orientation.sets.size()) {}

  std::vector<std::uint32_t> run() {
    if (!space_.has_emitters) return {};
    watch();
    look();
    std::vector<std::uint32_t> turned_over = chosen(&State::is_lamp_turned_over);
    return turned_over.empty() ? chosen(&State::looks_away) : turned_over;
  }

 private:
  struct State {
    bool front_may_be_lit = false;
    bool back_lit = false;
    bool open_emitter = false;
    bool front_sees_backs_only = true;
    bool back_sees_fronts_only = true;

    [[nodiscard]] bool looks_away() const { return back_lit && !front_may_be_lit; }
    [[nodiscard]] bool is_lamp_turned_over() const {
      return open_emitter && front_sees_backs_only && back_sees_fronts_only;
    }
  };

  [[nodiscard]] std::uint32_t set(FaceId face) const { return orientation_.set_of_face[face]; }

  [[nodiscard]] bool is_open_emitter(FaceId face) const {
    const std::uint32_t component = context_.topology.component_of_face[face];
    return context_.scene.materials[context_.material_of(face)].emits() &&
           !context_.topology.components[component].closed();
  }

  template <typename Visit>
  void for_each_side(Visit&& visit) const {
    for (std::uint32_t t = 0; t < space_.sheets.size(); ++t) {
      for (const int side : {0, 1}) visit(space_.cell(t, side), space_.sheets.front[t][side], space_.back(t, side));
    }
  }

  void watch() {
    watchers_.resize(space_.cells.size());
    for_each_side([&](CellId cell, FaceId front, FaceId back) {
      if (front != kNoFace) note(watchers_[cell].fronts, set(front));
      if (back != kNoFace) note(watchers_[cell].backs, set(back));
    });
  }

  void look() {
    for_each_side([&](CellId cell, FaceId front, FaceId back) {
      const Watchers& seen = watchers_[cell];
      if (front != kNoFace) {
        State& state = state_[set(front)];
        state.front_may_be_lit |= space_.may_be_lit[cell];
        state.open_emitter |= is_open_emitter(front);
        const bool others_backs = seen.backs != kNobody && seen.backs != set(front);
        state.front_sees_backs_only &= others_backs && nobody_but(seen.fronts, set(front));
      }
      if (back != kNoFace) {
        State& state = state_[set(back)];
        state.back_lit |= space_.lit[cell];
        const bool others_fronts = seen.fronts != kNobody && seen.fronts != set(back);
        state.back_sees_fronts_only &= others_fronts && nobody_but(seen.backs, set(back));
      }
    });
  }

  template <typename Condition>
  [[nodiscard]] std::vector<std::uint32_t> chosen(Condition condition) const {
    std::vector<std::uint32_t> sets;
    for (std::uint32_t i = 0; i < state_.size(); ++i) {
      if (orientation_.sets[i].orientable && (state_[i].*condition)()) sets.push_back(i);
    }
    return sets;
  }

  const Context& context_;
  const LitSpace& space_;
  const OrientationSets& orientation_;
  std::vector<State> state_;        ///< per set
  std::vector<Watchers> watchers_;  ///< per cell
};

}  // namespace

std::vector<std::uint32_t> sets_facing_away(const Context& context, const LitSpace& space,
                                            const OrientationSets& orientation) {
  return Facing(context, space, orientation).run();
}

}  // namespace rad::validate
