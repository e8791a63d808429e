#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  for (const FaceContact& contact : context.contacts.faces) {
    if (contact.kind != geom::ContactKind::Crossing) continue;
    const bool ordered = context.precedes(contact.a, contact.b);
    const dvec3 from = context.position(contact.segment[0]), to = context.position(contact.segment[1]);
    out.add({.faces = {ordered ? contact.a : contact.b, ordered ? contact.b : contact.a},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(contact.size)});
  }
}

double threshold(const Context& context) { return context.tolerance.length; }

}  // namespace

constinit const Rule implicit_intersection{
    .id = "RL210",
    .alias = "implicit-intersection",
    .title = "Faces pass through each other without an edge there",
    .message = "{n} pair{s} of faces {passes|pass} through each other{object}; the longest cut is {measure}",
    .requirement = Requirement::NoImplicitIntersections,
    .measure = {"length of the cut", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "isect",
    .citation = "baum91 2.2, 3.2",
    .doc = {.what = "The insides of two faces meet along a segment that is an edge of neither.",
            .why = "The mesh of either face knows nothing of the other. A node on the far side of the cut is dark, its "
                   "neighbour is lit, and interpolation between them leaks light or shadow across the line: the shadow "
                   "that creeps out from under the box in Color Plate 1.",
            .how = "Every pair of triangles of different faces whose boxes come within T; sides of planes are decided "
                   "exactly on the scene lattice. The segment must be longer than T and run along an edge of neither.",
            .fix = "radfix cuts both faces along the segment (Isect).",
            .modeller = "SketchUp: Intersect Faces > With Model. Blender: Boolean, or Edit Mode > Intersect (Knife). "
                        "Rhino: MeshSplit or MeshBooleanSplit. Revit: join geometry.",
            .limits = "Faces whose own outline crosses itself (RL009) and degenerate ones (RL007) are not tested."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
