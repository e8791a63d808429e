#include <algorithm>
#include <map>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

// Faces on the subedge by object; only an object with more than two of them is at fault.
std::map<scene::ObjectId, std::vector<FaceId>> faces_by_object(const Context& context, const Subedge& subedge) {
  std::map<scene::ObjectId, std::vector<FaceId>> faces;
  for (const Coedge& coedge : context.topology.coedges_of(subedge)) {
    faces[context.object_of(coedge.face)].push_back(coedge.face);
  }
  return faces;
}

void check(const Context& context, Violations& out) {
  for (const Subedge& subedge : context.topology.subedges) {
    if (subedge.count <= 2) continue;
    for (auto& [object, faces] : faces_by_object(context, subedge)) {
      if (faces.size() <= 2) continue;
      std::sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) { return context.precedes(a, b); });
      const dvec3 from = context.position(subedge.a), to = context.position(subedge.b);
      out.add({.faces = {faces[0], faces[1]},
               .point = (from + to) * 0.5,
               .segment = std::array{from, to},
               .measure = static_cast<double>(faces.size()),
               .cluster = context.topology.component_of_face[faces[0]] + std::uint64_t{1}});
    }
  }
}

}  // namespace

constinit const Rule nonmanifold_edge{
    .id = "RL102",
    .alias = "nonmanifold-edge",
    .title = "More than two faces of an object share an edge",
    .message = "{n} edge{s} used by more than two faces{object} (up to {measure})",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"faces on the edge", MeasureUnit::Count},
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "split-nonmanifold",
    .citation = "baum91 2.1",
    .doc = {.what = "Three or more faces of one object meet in an edge.",
            .why = "No solid has such an edge: inside and outside cannot be told apart around it, so that the outward "
                   "normal is not defined. Often an inner wall or a doubled face is left over inside the object.",
            .how =
                "Edges are matched at the tolerance. Faces of differently named objects are not counted together, so "
                "a wall that stands on a floor along a shared contour is no fault.",
            .fix = "Delete the inner face, or separate the object into two solids.",
            .modeller = "Blender: Select > All by Trait > Non Manifold. Rhino: ShowEdges, non-manifold. SketchUp: "
                        "Solid Inspector, internal face. Revit: unjoin the elements or export them one by one.",
            .limits = "Formats without object names count as one object: touching solids in an STL file are reported."},
    .check = &check,
};

}  // namespace rad::validate
