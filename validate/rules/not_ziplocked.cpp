#include "validate/edge_vertices.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_t_vertices(context, false, out); }

double threshold(const Context& context) { return context.tolerance.length; }

}  // namespace

constinit const Rule not_ziplocked{
    .id = "RL301",
    .alias = "not-ziplocked",
    .title = "A vertex lies inside an edge of another surface",
    .message = "{n} T-vertex point{s} between surfaces{object}, up to {measure} off the edge",
    .requirement = Requirement::Ziplocking,
    .measure = {"distance to the edge", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 2.3",
    .doc = {.what = "A vertex lies within the tolerance of the open inside of an edge of a face of another surface.",
            .why = "The solution may jump between surfaces, so the radiosity solution does not mind. The display does: "
                   "rounding in scan conversion leaves pixels open along such an edge.",
            .how = "As for RL201, for faces that are not of one surface. Left out where nothing but faces that lie on "
                   "each other back to back meets, as between a ceiling and a lamp under it: nobody sees them.",
            .fix = "radfix inserts the vertex into the edge, so that both sides share it (ziplocking).",
            .modeller = "As for RL201: SketchUp: draw over the edge. Revit: align the elements. Rhino: MeshMatchEdge. "
                        "Blender: Connect vertex and edge.",
            .limits = "Objects that merely touch are reported too: a table's corner on the edge of a rug."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
