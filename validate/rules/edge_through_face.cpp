#include <algorithm>
#include <tuple>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

bool crosses(const Context& context, const FaceContact& contact) {
  const auto& all = context.contacts.faces;
  const FaceContact wanted{contact.a, contact.b, geom::ContactKind::Crossing, true, 0, {}};
  const auto order = [](const FaceContact& x, const FaceContact& y) {
    return std::tuple(x.a, x.b, x.kind) < std::tuple(y.a, y.b, y.kind);
  };
  return std::binary_search(all.begin(), all.end(), wanted, order);
}

void check(const Context& context, Violations& out) {
  for (const FaceContact& contact : context.contacts.faces) {
    if (contact.kind != geom::ContactKind::EdgeInFace || crosses(context, contact)) continue;
    const bool ordered = context.precedes(contact.a, contact.b);
    const dvec3 from = context.position(contact.segment[0]), to = context.position(contact.segment[1]);
    out.add({.faces = {ordered ? contact.a : contact.b, ordered ? contact.b : contact.a},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(contact.size)});
  }
}

}  // namespace

constinit const Rule edge_through_face{
    .id = "RL211",
    .alias = "edge-through-face",
    .title = "An edge meets the inside of a face without a vertex or edge there",
    .message =
        "{n} pair{s} of faces {touches|touch} where only one has an edge{object}; the longest contact is {measure}",
    .requirement = Requirement::NoImplicitIntersections,
    .measure = {"length of the contact", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "isect",
    .citation = "baum91 2.2, 3.2",
    .doc = {.what =
                "An edge or corner of one face lies in the inside of another within the tolerance, or pierces it, or "
                "two edges cross, and the other face has no edge or vertex there: a wall or table leg that stands on "
                "a floor whose mesh does not show its outline.",
            .why =
                "As for RL210: without a contour in the floor, nodes under the leg are dark, their neighbours lit, and "
                "the shadow leaks out.",
            .how =
                "Every pair of triangles of different faces whose boxes come within T. Contacts along an edge of both "
                "faces are none, nor is a corner on the other's edge (RL201, RL301). A pair that also passes through "
                "is reported as RL210 only.",
            .fix = "radfix draws the contact into the face (Isect).",
            .modeller = "SketchUp: Intersect Faces > With Model draws the outline. Blender: Intersect (Knife). Rhino: "
                        "project the outline and split the mesh. Revit: join geometry.",
            .limits = "A gap wider than T is no contact; whether it is meant to be one is not asked here. Two edges "
                      "that pass each other count only where they meet, not where a gap is left."},
    .check = &check,
};

}  // namespace rad::validate
