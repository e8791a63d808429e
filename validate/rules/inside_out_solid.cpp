#include <algorithm>
#include <cmath>

#include "validate/component_members.h"
#include "validate/rules.h"
#include "validate/winding.h"

namespace rad::validate {
namespace {

dvec3 lattice_centre(const Context& context, FaceId face) {
  return (context.centre(face) - context.model.lattice.origin) / context.model.lattice.pitch;
}

// Touching from outside winds by a half: only a face clearly inside counts.
bool lies_inside(const Context& context, const ComponentMembers& members, std::uint32_t inner, std::uint32_t outer) {
  constexpr double kClearlyInside = 0.75;
  return std::any_of(members.faces[inner].begin(), members.faces[inner].end(), [&](FaceId face) {
    const dvec3 point = lattice_centre(context, face);
    return std::abs(winding_number(context, members.triangles[outer], point)) > kClearlyInside;
  });
}

// An inward-facing surface is right where it is a room (something is in it, or it shines into itself) or the inner
// skin of a hollow solid.
bool meant_inward(const Context& context, const ComponentMembers& members, std::uint32_t id) {
  if (any_emits(context, members.faces[id])) return true;
  const auto& components = context.topology.components;
  for (std::uint32_t other = 0; other < components.size(); ++other) {
    if (other == id) continue;
    if (box_inside(components[other], components[id]) && lies_inside(context, members, other, id)) return true;
    const bool outer_skin = components[other].closed() && components[other].volume6 > 0;
    if (outer_skin && box_inside(components[id], components[other]) && lies_inside(context, members, id, other)) {
      return true;
    }
  }
  return false;
}

dvec3 middle_of(const Context& context, const Component& component) {
  const geom::LatticePoint& a = component.low;
  const geom::LatticePoint& b = component.high;
  return context.position(dvec3(a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y), a.z + 0.5 * (b.z - a.z)));
}

void check(const Context& context, Violations& out) {
  const auto& components = context.topology.components;
  const auto suspect = [&](const Component& c) { return c.closed() && c.volume6 < 0 && has_volume(context, c); };
  if (std::none_of(components.begin(), components.end(), suspect)) return;
  const ComponentMembers members = members_of_components(context);
  for (std::uint32_t id = 0; id < components.size(); ++id) {
    if (!suspect(components[id]) || meant_inward(context, members, id)) continue;
    const double pitch = context.model.lattice.pitch;
    out.add({.faces = {first_face(context, members.faces[id]), kNoFace},
             .point = middle_of(context, components[id]),
             .measure = volume_of(components[id]) * pitch * pitch * pitch,
             .cluster = id + std::uint64_t{1}});
  }
}

}  // namespace

constinit const Rule inside_out_solid{
    .id = "RL104",
    .alias = "inside-out-solid",
    .title = "A closed object faces inward",
    .message = "closed object faces inward{object}: it encloses {measure} with its back sides out",
    .requirement = Requirement::NormalConsistency,
    .measure = {"enclosed volume", MeasureUnit::Volume},
    .fix = scene::FixClass::Safe,
    .fix_operation = "orient",
    .citation = "baum91 2.1",
    .doc = {.what = "All faces of a closed object look into it.",
            .why = "Its outside is all back sides: it blocks light but reflects none, and stands black in the scene.",
            .how =
                "A closed component whose signed volume is negative. It is taken for a room, and not reported, where "
                "something stands in it or one of its own faces emits light; and for a cavity where it lies inside "
                "another closed object.",
            .fix = "radfix turns it. If it is meant as an empty room seen from inside, put a light or an object in it.",
            .modeller = "SketchUp: Reverse Faces on the group. Blender: Mesh > Normals > Recalculate Outside. Rhino: "
                        "Flip. Revit: mirrored or negatively scaled families cause it; place them anew.",
            .limits = "Rooms that are empty and unlit are reported."},
    .check = &check,
};

}  // namespace rad::validate
