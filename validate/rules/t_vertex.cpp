#include "validate/edge_vertices.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_t_vertices(context, true, out); }

double threshold(const Context& context) { return context.tolerance.length; }

}  // namespace

constinit const Rule t_vertex{
    .id = "RL201",
    .alias = "t-vertex",
    .title = "A vertex lies inside an edge of the same surface",
    .message = "{n} T-vertex point{s} inside edges of the same surface{object}, up to {measure} off the edge",
    .requirement = Requirement::NoTVertices,
    .measure = {"distance to the edge", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 2.2",
    .doc = {.what =
                "A vertex of one face lies within the tolerance of the open inside of an edge of another face of the "
                "same surface, and the edge does not stop there (Figure 2 of the paper).",
            .why = "The vertex carries a radiosity of its own, the edge interpolates straight past it: the solution is "
                   "discontinuous there, which shows as a seam, and the display cracks.",
            .how =
                "Distance from vertex to edge at most T, and more than T from both ends along it: exact on the scene "
                "lattice. A surface is a set of faces of one material that meet within 30 degrees.",
            .fix = "radfix inserts the vertex into the edge (Grouper).",
            .modeller = "SketchUp: draw over the edge to break it at the vertex. Blender: select edge and vertex, "
                        "Connect or Subdivide and Merge. Rhino: MeshMatchEdge, SplitMeshEdge. Revit: elements that "
                        "meet are not split; leave it to radfix.",
            .limits = "A vertex nearer than T to the end of the edge counts as that end (RL302)."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
