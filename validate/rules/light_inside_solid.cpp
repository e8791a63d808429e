#include <algorithm>

#include "validate/component_members.h"
#include "validate/enclosures.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

bool faces_outward(const Component& component) { return component.volume6 > 0; }

void check(const Context& context, Violations& out) {
  const auto& faces = context.scene.faces;
  const bool any = std::ranges::any_of(
      faces, [&](const scene::Face& face) { return context.scene.materials[face.material].emits(); });
  if (!any) return;
  const std::vector<std::uint32_t>& around = enclosing_components(context);
  const ComponentMembers members = members_of_components(context);
  const auto& components = context.topology.components;
  for (std::uint32_t id = 0; id < components.size(); ++id) {
    if (around[id] == kNoComponent || !faces_outward(components[around[id]])) continue;
    if (!any_emits(context, members.faces[id])) continue;
    // A room that is turned over is RL112.
    if (facades_of(context).of_component[around[id]].verdict == FacadeVerdict::TurnedOver) continue;
    std::vector<FaceId> lamps = members.faces[id];
    std::erase_if(lamps, [&](FaceId face) { return !any_emits(context, {face}); });
    const FaceId lamp = first_face(context, lamps);
    out.add({.faces = {lamp, first_face(context, members.faces[around[id]])},
             .point = context.centre(lamp),
             .count = lamps.size(),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule light_inside_solid{
    .id = "RL420",
    .alias = "light-inside-solid",
    .title = "A light is shut up in a solid",
    .message = "{n} emitting face{s} inside a closed object{object}: no light gets out",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "Faces that emit light lie wholly inside of a closed object that faces outward.",
            .why = "The light falls on the backs of its walls and is lost there. A lamp behind its own glass bulb "
                   "lights nothing.",
            .how = "The smallest closed component that encloses the emitter faces outward. Rooms and cavities face "
                   "inward and hold lights as they should.",
            .fix = "Delete the glass around the lamp or give it the emission; open the shade; give the housing its "
                   "inner skin.",
            .modeller = "SketchUp, Revit: lamp families come with glass: hide it or paint it with the light. Blender, "
                        "Rhino: delete the bulb's glass, or move the emission to it.",
            .limits = "An emitter that touches the object around it from within is not reported, nor one whose object "
                      "is dark from "
                      "outside: that is taken for a room that is turned over (RL112)."},
    .check = &check,
};

}  // namespace rad::validate
