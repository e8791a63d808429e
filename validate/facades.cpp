#include "validate/facades.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "validate/facade_gap.h"
#include "validate/facing.h"
#include "validate/orientation_sets.h"
#include "validate/sight_lines.h"
#include "validate/terrain.h"

namespace rad::validate {
namespace {

class Judge {
 public:
  explicit Judge(const Context& context) : context_(context), components_(context.topology.components) {}

  Facades run() {
    facades_.of_component.resize(components_.size());
    if (!any_facade() && !may_face_away(context_)) return std::move(facades_);
    for (std::uint32_t i = 0; i < components_.size(); ++i) {
      if (is_facade(i)) facades_.of_component[i].verdict = FacadeVerdict::Undecided;
    }
    const std::optional<LitSpace> space = find_lit_space(context_);
    if (!space) return std::move(facades_);
    space_ = &*space;
    facades_.has_emitters = space->has_emitters;
    decide();
    return std::move(facades_);
  }

 private:
  [[nodiscard]] bool is_facade(std::uint32_t component) const { return components_[component].open_subedges > 0; }

  [[nodiscard]] bool any_facade() const {
    return std::ranges::any_of(components_, [](const Component& c) { return c.open_subedges > 0; });
  }

  // One-sided surfaces are judged as they are: no turning would change what is seen of them.
  [[nodiscard]] std::vector<bool> components_that_disagree() const {
    std::vector<bool> disagree(components_.size(), false);
    for (const auto& item : disagreements_of(context_)) {
      disagree[context_.topology.component_of_face[item.faces[0]]] = true;
    }
    return disagree;
  }

  void find_sets_turned_over() {
    facades_.turned_over = sets_facing_away(context_, *space_);
    is_turned_over_.assign(context_.scene.faces.size(), false);
    for (const std::vector<FaceId>& faces : facades_.turned_over) {
      for (const FaceId face : faces) is_turned_over_[face] = true;
    }
  }

  // Backs of faces that are to be turned are in the light for that reason alone.
  void gather_backs() {
    backs_.resize(components_.size());
    for (std::uint32_t t = 0; t < space_->sheets.size(); ++t) {
      for (const int side : {0, 1}) {
        const FaceId back = space_->back(t, side);
        if (back == kNoFace || !space_->lit[space_->cell(t, side)]) continue;
        const std::uint32_t component = context_.topology.component_of_face[back];
        Facade& facade = facades_.of_component[component];
        if (is_turned_over_[back]) {
          facade.verdict = FacadeVerdict::TurnedOver;
          continue;
        }
        backs_[component].push_back({t, side});
        facade.lit_back_area += area_of(t);  // whole numbers: exact in any order
      }
    }
  }

  [[nodiscard]] double area_of(std::uint32_t triangle) const {
    const auto& t = space_->sheets.triangles[triangle];
    const auto& points = context_.model.points;
    return std::nearbyint(geom::TrianglePlane(points[t[0]], points[t[1]], points[t[2]]).normal_length / 2);
  }

  void decide() {
    find_sets_turned_over();
    gather_backs();
    const std::vector<bool> disagree = components_that_disagree();
    std::vector<std::uint32_t> in_question;
    for (std::uint32_t i = 0; i < components_.size(); ++i) {
      Facade& facade = facades_.of_component[i];
      if (!is_facade(i) || disagree[i]) continue;
      if (!backs_[i].empty()) {
        facade.verdict = FacadeVerdict::ProbablyValid;
        in_question.push_back(i);
      } else if (facade.verdict == FacadeVerdict::Undecided) {
        facade.verdict = FacadeVerdict::ValidProved;
      }
    }
    if (!in_question.empty()) look_from_backs(in_question);
  }

  void look_from_backs(const std::vector<std::uint32_t>& in_question) {
    const SightLines lines(context_, *space_);
    const int rays = in_question.size() > kManyFacades ? kFewSightRays : kSightRays;
    tbb::parallel_for(std::size_t{0}, in_question.size(),
                      [&](std::size_t i) { look_from(lines, in_question[i], rays); });
    const auto is_invalid = [](const Facade& f) { return f.verdict == FacadeVerdict::InvalidProved; };
    if (std::ranges::none_of(facades_.of_component, is_invalid)) return;
    const FacadeGaps gaps(context_);
    tbb::parallel_for(std::size_t{0}, facades_.of_component.size(), [&](std::size_t i) {
      Facade& facade = facades_.of_component[i];
      if (is_invalid(facade)) facade.gap = gaps.narrowest(static_cast<std::uint32_t>(i));
    });
  }

  void look_from(const SightLines& lines, std::uint32_t component, int rays) {
    Facade& facade = facades_.of_component[component];
    const Ground ground = ground_of(context_, *space_, backs_[component]);
    if (ground.shape == GroundShape::Border) {
      facade.verdict = FacadeVerdict::Terrain;
      return;
    }
    const bool field = ground.shape == GroundShape::HeightField;
    // Of ground, neither open space below it counts nor what is sunk into it.
    const auto counts = [&](FaceId front) {
      if (!field) return true;
      return front != kNoFace && !ground.is_pierced_by(components_[context_.topology.component_of_face[front]]);
    };
    const auto line = lines.find(backs_[component], rays, counts);
    if (field && !line) {
      facade.verdict = FacadeVerdict::Terrain;
    } else if (line) {
      facade.verdict = FacadeVerdict::InvalidProved;
      facade.face = line->back;
      facade.sight = line->ends;
      facade.from_open_space = line->front == kNoFace;
    } else {
      facade.rays = rays;
    }
  }

  const Context& context_;
  const std::vector<Component>& components_;
  const LitSpace* space_ = nullptr;
  std::vector<bool> is_turned_over_;          ///< per face
  std::vector<std::vector<BackSide>> backs_;  ///< per component, in lit cells
  Facades facades_;
};

}  // namespace

const Facades& facades_of(const Context& context) {
  if (!context.facades) context.facades = Judge(context).run();
  return *context.facades;
}

}  // namespace rad::validate
