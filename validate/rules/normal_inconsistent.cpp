#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "validate/context.h"
#include "validate/orientation_sets.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

// How many edges of each face are at fault: a face that is flipped alone has more of them than its neighbours.
std::map<FaceId, int> faults_of_faces(const std::vector<Disagreement>& disagreements) {
  std::map<FaceId, int> faults;
  for (const Disagreement& item : disagreements) {
    for (const FaceId face : item.faces) ++faults[face];
  }
  return faults;
}

void check(const Context& context, Violations& out) {
  const std::vector<Disagreement> disagreements = disagreements_of(context);
  const std::map<FaceId, int> faults = faults_of_faces(disagreements);
  for (const Disagreement& item : disagreements) {
    FaceId suspect = item.faces[0], other = item.faces[1];
    const int a = faults.at(suspect), b = faults.at(other);
    if (b > a || (b == a && context.precedes(other, suspect))) std::swap(suspect, other);
    const Subedge& subedge = *item.subedge;
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
                   "objects and materials; of more, where exactly two are of one object, or where of four of one "
                   "named object two lie on each other.",
            .fix =
                "radfix turns the smaller part by area of what is connected, then closed objects outward (RL104) and "
                "what light proves to be turned over (RL112).",
            .modeller = "SketchUp: Reverse Faces, Orient Faces. Blender: Mesh > Normals > Recalculate Outside. Rhino: "
                        "UnifyMeshNormals. Revit exports consistent normals; check the link that joined the parts.",
            .limits =
                "A one-sided surface, such as a Möbius strip, cannot be made consistent: RL115 reports it. Two faces "
                "that lie over each other from their common edge on, less than 2.6 degrees apart, are no "
                "neighbours."},
    .check = &check,
};

}  // namespace rad::validate
