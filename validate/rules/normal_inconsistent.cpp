#include "validate/context.h"
#include "validate/rules.h"

#include <cmath>

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  for (const Subedge& subedge : context.topology.subedges) {
    const auto coedges = context.topology.coedges_of(subedge);
    if (coedges.size() != 2 || coedges[0].forward != coedges[1].forward) continue;
    const dvec3 from = context.position(subedge.a), to = context.position(subedge.b);
    const auto squared = geom::squared_distance(context.model.points[subedge.a], context.model.points[subedge.b]);
    out.add({.faces = {coedges[0].face, coedges[1].face},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(std::sqrt(static_cast<double>(squared)))});
  }
}

}  // namespace

constinit const Rule normal_inconsistent{
    .id = "RL110",
    .alias = "normal-inconsistent",
    .title = "Neighbouring faces look opposite ways",
    .message = "{n} edge{s} between faces that look opposite ways{object}; the longest is {measure}",
    .requirement = Requirement::NormalConsistency,
    .measure = {"edge length", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "orient",
    .citation = "baum91 2.1",
    .doc =
        {.what = "Two faces that share an edge run along it in the same direction: the front of one continues as the "
                 "back of the other.",
         .why = "Faces radiate and receive on their front only. A flipped face is black, lets no light out, and the "
                "energy that should meet it is lost.",
         .how = "Edges are matched at the tolerance and tested where exactly two faces use them, whatever their "
                "objects and materials.",
         .fix = "radfix turns the minority by area where the orientation is proved; elsewhere flip the faces by hand.",
         .modeller = "SketchUp: Reverse Faces, Orient Faces. Blender: Mesh > Normals > Recalculate Outside. Rhino: "
                     "UnifyMeshNormals. Revit exports consistent normals; check the link that joined the parts.",
         .limits = "A one-sided (Möbius) surface cannot be made consistent."},
    .check = &check,
};

}  // namespace rad::validate
