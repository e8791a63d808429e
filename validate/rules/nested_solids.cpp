#include "validate/component_members.h"
#include "validate/enclosures.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

dvec3 middle_of(const Context& context, const Component& component) {
  const geom::LatticePoint &a = component.low, &b = component.high;
  return context.position(dvec3(a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y), a.z + 0.5 * (b.z - a.z)));
}

bool is_solid(const Context& context, const Component& component) {
  return component.closed() && component.volume6 > 0 && has_volume(context, component);
}

void check(const Context& context, Violations& out) {
  const auto& components = context.topology.components;
  const std::vector<std::uint32_t>& around = enclosing_components(context);
  std::optional<ComponentMembers> members;
  for (std::uint32_t id = 0; id < components.size(); ++id) {
    const bool in_solid = around[id] != kNoComponent && is_solid(context, components[around[id]]);
    if (!in_solid || !is_solid(context, components[id])) continue;
    if (!members) members = members_of_components(context);
    if (any_emits(context, members->faces[id])) continue;  // RL420
    out.add({.faces = {first_face(context, members->faces[id]), first_face(context, members->faces[around[id]])},
             .point = middle_of(context, components[id]),
             .measure = context.length(1) * context.area(volume_of(components[id])),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule nested_solids{
    .id = "RL106",
    .alias = "nested-solids",
    .title = "A solid lies inside another solid",
    .message = "{n} solid{s} inside the matter of another{object}, the largest of {measure}",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"enclosed volume", MeasureUnit::Volume},
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "cull-hidden",
    .citation = "baum91 2.1",
    .doc = {.what = "A closed object lies wholly inside of another closed object, and both face outward.",
            .why = "Between the two is matter and no air: the inner one is never seen and never lit. It costs patches "
                   "and time. Often the outer one should be hollow, and its inner skin is missing.",
            .how = "The smallest closed component that encloses the solid faces outward. Exact rays from the first and "
                   "the last triangle of the inner one count walls by parity. Cavities and rooms face inward, so that "
                   "what stands in them is not reported; inner objects that emit light are RL420.",
            .fix = "Delete the inner object, or give the outer one its inner skin (a wall thickness).",
            .modeller = "Blender: Select > All by Trait > Interior Faces, or Solidify the outer object. Rhino: "
                        "BooleanUnion drops inner solids. SketchUp: Outer Shell. Revit: export the finish faces only.",
            .limits = "An object that touches the outer one from within, or passes through its wall, is not reported."},
    .check = &check,
};

}  // namespace rad::validate
