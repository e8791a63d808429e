#include <cmath>

#include "validate/context.h"
#include "validate/edge_vertices.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  const auto& pairs = context.contacts.near_vertices;
  for (std::size_t begin = 0; begin < pairs.size();) {
    std::size_t end = begin;
    const NearVertices* named = &pairs[begin];
    bool in_sight = false;
    for (; end < pairs.size() && pairs[end].a == pairs[begin].a && pairs[end].b == pairs[begin].b; ++end) {
      const bool better = context.precedes(pairs[end].a_face, named->a_face) ||
                          (pairs[end].a_face == named->a_face && context.precedes(pairs[end].b_face, named->b_face));
      if (better) named = &pairs[end];
      in_sight = in_sight || !back_to_back(context, pairs[end].a_face, pairs[end].b_face);
    }
    begin = end;
    if (!in_sight) continue;
    const dvec3 a = context.position(named->a), b = context.position(named->b);
    const auto squared = geom::squared_distance(context.model.points[named->a], context.model.points[named->b]);
    out.add({.faces = {named->a_face, named->b_face},
             .point = (a + b) * 0.5,
             .segment = std::array{a, b},
             .measure = context.length(std::sqrt(static_cast<double>(squared)))});
  }
}

double threshold(const Context& context) { return context.tolerance.length; }

}  // namespace

constinit const Rule crack{
    .id = "RL302",
    .alias = "crack",
    .title = "Corners that belong together differ by less than the tolerance",
    .message = "{n} pair{s} of corners that nearly meet{object}, up to {measure} apart",
    .requirement = Requirement::Ziplocking,
    .measure = {"gap", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 2.3, 3.1",
    .doc = {.what = "Corners of two faces lie within the tolerance of each other but not in the same place.",
            .why = "There is a hairline gap or overlap between the faces: pixels drop out in the display, and rays can "
                   "slip through in the solution.",
            .how = "Distance greater than 0 on the scene lattice and at most T. Left out where nothing but faces that "
                   "lie on each other back to back meets: nobody sees them.",
            .fix = "radfix welds them (Grouper).",
            .modeller = "Blender: Merge by Distance. Rhino: AlignMeshVertices, Weld. SketchUp merges them on import "
                        "when the model is scaled up. Revit: Align and lock the faces that should meet.",
            .limits = "Details smaller than T are reported too; make T smaller with --tolerance."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
