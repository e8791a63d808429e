#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

std::string_view flaw_of(const Context& context, FaceId id) {
  if (context.triangles.condition[id] == FaceCondition::RingCrosses) return "edges of one face cross each other";
  switch (context.triangles.flaw[id]) {
    case RingFlaw::RepeatedPoint:
      return "a corner is repeated";
    case RingFlaw::Spike:
      return "an edge runs out and back";
    case RingFlaw::HoleOutside:
      return "a hole lies outside its face";
    case RingFlaw::None:
      break;
  }
  return {};
}

void check(const Context& context, Violations& out) {
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (context.triangles.condition[id] == FaceCondition::Degenerate) continue;  // RL007 says it
    const std::string_view flaw = flaw_of(context, id);
    if (flaw.empty()) continue;
    const bool crosses = context.triangles.condition[id] == FaceCondition::RingCrosses;
    out.add({.faces = {id, kNoFace},
             .point = context.centre(id),
             .cluster = kPerParticipants + (crosses ? 1u : static_cast<unsigned>(context.triangles.flaw[id]) + 1),
             .detail = flaw});
  }
}

}  // namespace

constinit const Rule ring_defect{
    .id = "RL009",
    .alias = "ring-defect",
    .title = "The outline of a face is not a simple ring",
    .message = "{detail}: {n} face{s}{object}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "drop-bad-faces",
    .citation = "baum91 2.2",
    .doc =
        {.what = "The outline of a face crosses itself, repeats a corner, runs out along an edge and back, or has a "
                 "hole that lies outside.",
         .why = "Such a face has no well-defined inside, so that no mesh can be laid over it.",
         .how = "Exact, in the projection along the face's dominant axis. Touching itself in a corner or along a "
                "bridge to a hole is legal. A face whose edges cross takes no part in the rules on contacts.",
         .fix =
             "Redraw the face, or look at what radfix makes of it: it keeps what an odd number of outlines encloses.",
         .modeller = "Blender: select the face, delete it and fill the outline again. SketchUp: redraw one edge of the "
                     "face. Rhino: rebuild the boundary curve with SelfIntersect-free segments. Revit: edit the sketch "
                     "of the element.",
         .limits = "Rings are tested against themselves and each other, not against other faces."},
    .check = &check,
};

}  // namespace rad::validate
