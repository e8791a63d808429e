#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

bool is_inconsistent(std::span<const Coedge> coedges) {
  return coedges.size() == 2 && coedges[0].forward == coedges[1].forward;
}

// How many edges of each face are at fault: a face that is flipped alone has more of them than its neighbours.
std::map<FaceId, int> faults_of_faces(const Topology& topology) {
  std::map<FaceId, int> faults;
  for (const Subedge& subedge : topology.subedges) {
    const auto coedges = topology.coedges_of(subedge);
    if (!is_inconsistent(coedges)) continue;
    ++faults[coedges[0].face];
    ++faults[coedges[1].face];
  }
  return faults;
}

void check(const Context& context, Violations& out) {
  const std::map<FaceId, int> faults = faults_of_faces(context.topology);
  for (const Subedge& subedge : context.topology.subedges) {
    const auto coedges = context.topology.coedges_of(subedge);
    if (!is_inconsistent(coedges)) continue;
    FaceId suspect = coedges[0].face, other = coedges[1].face;
    const int a = faults.at(suspect), b = faults.at(other);
    if (b > a || (b == a && context.precedes(other, suspect))) std::swap(suspect, other);
    const dvec3 from = context.position(subedge.a), to = context.position(subedge.b);
    const auto squared = geom::squared_distance(context.model.points[subedge.a], context.model.points[subedge.b]);
    out.add({.faces = {suspect, other},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(std::sqrt(static_cast<double>(squared))),
             .cluster = context.topology.component_of_face[suspect] + std::uint64_t{1}});
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
    .doc = {.what =
                "Two faces that share an edge run along it in the same direction: the front of one continues as the "
                "back of the other.",
            .why = "Faces radiate and receive on their front only. A flipped face is black, lets no light out, and the "
                   "energy that should meet it is lost.",
            .how = "Edges are matched at the tolerance and tested where exactly two faces use them, whatever their "
                   "objects and materials.",
            .fix = "radfix turns the smaller part by area of what is connected; where no turning makes all agree, flip "
                   "faces by hand.",
            .modeller = "SketchUp: Reverse Faces, Orient Faces. Blender: Mesh > Normals > Recalculate Outside. Rhino: "
                        "UnifyMeshNormals. Revit exports consistent normals; check the link that joined the parts.",
            .limits = "A one-sided (Möbius) surface cannot be made consistent."},
    .check = &check,
};

}  // namespace rad::validate
