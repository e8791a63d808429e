#include "validate/enclosures.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "geom/box_tree.h"
#include "validate/component_members.h"
#include "validate/interior_ray.h"

namespace rad::validate {
namespace {

using Components = std::vector<std::uint32_t>;

constexpr std::uint32_t kNoTriangle = 0xffffffffu;

geom::LatticeBox box_of_component(const Component& component) {
  return geom::box_of(std::array{component.low, component.high});
}

class Enclosures {
 public:
  explicit Enclosures(const Context& context) : context_(context), components_(context.topology.components) {
    for (const Component& component : components_) {
      can_hold_.push_back(component.closed() && has_volume(context, component));
    }
  }

  Components run() {
    Components around(components_.size(), kNoComponent);
    const Components inner = inner_components();
    if (inner.empty()) return around;
    find_extreme_triangles();
    tbb::parallel_for(std::size_t{0}, inner.size(),
                      [&](std::size_t i) { around[inner[i]] = smallest(holding(inner[i])); });
    return around;
  }

 private:
  // Those whose box lies in the box of one that can hold them.
  [[nodiscard]] Components inner_components() const {
    std::vector<geom::LatticeBox> boxes;
    Components holders;
    for (std::uint32_t i = 0; i < components_.size(); ++i) {
      if (!can_hold_[i]) continue;
      boxes.push_back(box_of_component(components_[i]));
      holders.push_back(i);
    }
    Components inner;
    if (holders.empty() || components_.size() < 2) return inner;
    const geom::BoxTree tree(std::move(boxes));
    for (std::uint32_t i = 0; i < components_.size(); ++i) {
      bool held = false;
      tree.for_each_meeting(box_of_component(components_[i]), [&](std::uint32_t holder) {
        held = held || (holders[holder] != i && box_inside(components_[i], components_[holders[holder]]));
      });
      if (held) inner.push_back(i);
    }
    return inner;
  }

  [[nodiscard]] std::uint32_t component_of(std::uint32_t triangle) const {
    return context_.topology.component_of_face[context_.triangles.triangles[triangle].face];
  }

  // By the ids of their corners, which follow the places.
  void find_extreme_triangles() {
    extremes_.assign(components_.size(), {kNoTriangle, kNoTriangle});
    const auto& triangles = context_.triangles.triangles;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      auto& [first, last] = extremes_[component_of(i)];
      if (first == kNoTriangle || triangles[i].points < triangles[first].points) first = i;
      if (last == kNoTriangle || triangles[i].points > triangles[last].points) last = i;
    }
  }

  // Components with an odd number of walls on the ray, ascending.
  [[nodiscard]] Components odd_on_ray(const InteriorRay& ray, std::uint32_t own) const {
    Components met;
    context_.contacts.tree->for_each_meeting(ray.box(), [&](std::uint32_t triangle) {
      const std::uint32_t component = component_of(triangle);
      if (component == own || !can_hold_[component]) return;
      if (ray.passes(context_.triangles.geometry[triangle].points)) met.push_back(component);
    });
    std::ranges::sort(met);
    Components odd;
    for (std::size_t begin = 0; begin < met.size();) {
      std::size_t end = begin;
      while (end < met.size() && met[end] == met[begin]) ++end;
      if ((end - begin) % 2 == 1) odd.push_back(met[begin]);
      begin = end;
    }
    return odd;
  }

  [[nodiscard]] Components holding(std::uint32_t inner) const {
    Components common;
    bool any = false;
    for (const std::uint32_t triangle : extremes_[inner]) {
      if (triangle == kNoTriangle) return {};
      for (const bool in_front : {true, false}) {
        const Components odd = odd_on_ray(InteriorRay(context_.triangles.geometry[triangle].points, in_front), inner);
        Components both;
        std::ranges::set_intersection(any ? common : odd, odd, std::back_inserter(both));
        common = std::move(both);
        any = true;
      }
    }
    return common;
  }

  [[nodiscard]] std::uint32_t smallest(const Components& holders) const {
    const auto volume = [&](std::uint32_t id) { return volume_of(components_[id]); };
    const auto found = std::ranges::min_element(holders, {}, volume);
    return found == holders.end() ? kNoComponent : *found;
  }

  const Context& context_;
  const std::vector<Component>& components_;
  std::vector<bool> can_hold_;
  std::vector<std::array<std::uint32_t, 2>> extremes_;
};

}  // namespace

const std::vector<std::uint32_t>& enclosing_components(const Context& context) {
  if (!context.enclosing) context.enclosing = Enclosures(context).run();
  return *context.enclosing;
}

}  // namespace rad::validate
