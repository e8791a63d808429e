#include <glm/geometric.hpp>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (context.triangles.condition[id] != FaceCondition::Degenerate) continue;
    const double area = context.area(glm::length(context.triangles.normal[id]) / 2);
    out.add({.faces = {id, kNoFace}, .point = context.centre(id), .measure = area, .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule degenerate_face{
    .id = "RL007",
    .alias = "degenerate-face",
    .title = "A face has no area to speak of",
    .message = "{n} face{s} nowhere thicker than the tolerance{object}; the least area is {measure}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Error,
    .measure = {"area", MeasureUnit::Area, true},
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 2.2",
    .doc =
        {.what = "A face has fewer than three distinct corners, or is nowhere thicker than the tolerance T.",
         .why = "It has no normal, its form factors are undefined, and its needle corners spoil the interpolation of "
                "whatever surrounds it.",
         .how = "A triangle: some corner lies within T of the opposite edge (exact). A polygon: twice its area is at "
                "most T times its diameter. Such faces take no part in the rules on contacts and connectivity.",
         .fix = "radfix leaves them out and joins what lay on either side of them (Grouper).",
         .modeller =
             "Blender: Mesh > Clean Up > Degenerate Dissolve. Rhino: CullDegenerateMeshFaces. SketchUp: CleanUp "
             "extension, erase stray edges. Revit writes them for slivers of joined elements: unjoin or align these.",
         .limits = "What is thinner than T but meant (a wire modelled as a strip) is reported here too; make T smaller "
                   "with --tolerance."},
    .check = &check,
};

}  // namespace rad::validate
