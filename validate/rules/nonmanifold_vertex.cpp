#include "validate/rules.h"
#include "validate/vertex_fans.h"

namespace rad::validate {
namespace {

// One violation for each vertex and object, at the first face of each of two fans.
void check(const Context& context, Violations& out) {
  for (const PinchedVertex& pinched : find_pinched_vertices(context)) {
    out.add({.faces = pinched.faces,
             .point = context.position(pinched.vertex),
             .measure = static_cast<double>(pinched.fans),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule nonmanifold_vertex{
    .id = "RL103",
    .alias = "nonmanifold-vertex",
    .title = "Fans of faces of an object touch in one vertex only",
    .message = "{n} vertex point{s} where fans of faces touch without an edge in common{object} (up to {measure} fans)",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Review,
    .measure = {"fans at the vertex", MeasureUnit::Count},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "The faces of one object around a vertex form two or more fans that share the vertex and no edge, "
                    "as two cones do that touch with their tips.",
            .why = "No solid has such a vertex. Light is not lost there, since every surface has values of its own at "
                   "the vertex, but it often means that a part was moved by a corner too far, or that a face is gone.",
            .how = "Faces at a vertex that share an edge there belong to one fan. Edges are matched at the tolerance: "
                   "vertices within T count as one. Fans of differently named objects are not counted together.",
            .fix = "Move the parts apart, or join them along an edge.",
            .modeller = "Blender: Select > All by Trait > Non Manifold, Vertices. Rhino: ShowEdges, non-manifold. "
                        "SketchUp: Solid Inspector. Revit: the parts come from different families; leave them.",
            .limits = "Formats without object names count as one object: solids in an STL file that touch in a corner "
                      "are reported."},
    .check = &check,
};

}  // namespace rad::validate
