#include <algorithm>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  for (const std::vector<FaceId>& faces : facades_of(context).turned_over) {
    const FaceId first =
        *std::min_element(faces.begin(), faces.end(), [&](FaceId a, FaceId b) { return context.precedes(a, b); });
    out.add({.faces = {first, kNoFace},
             .point = context.centre(first),
             .measure = static_cast<double>(faces.size()),
             .cluster = context.topology.component_of_face[first] + std::uint64_t{1}});
  }
}

}  // namespace

constinit const Rule facade_facing_away{
    .id = "RL112",
    .alias = "facade-facing-away",
    .title = "A surface looks away from the light",
    .message = "turned over{object}: fronts lie in the dark and backs in light; connected faces: {measure}",
    .requirement = Requirement::NormalConsistency,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"faces", MeasureUnit::Count},
    .fix = scene::FixClass::Safe,
    .fix_operation = "orient",
    .citation = "baum91 2.1",
    .doc = {.what = "No light can reach the front of any face of a connected set, and light reaches their backs.",
            .why = "The set sends no light and shows black: a room that was drawn with its normals outward, or a lamp "
                   "that shines into the ceiling it hangs in.",
            .how = "As for RL113, in air cells: no front lies in a cell that holds an emitter, a back does. Of an "
                   "emitter that is not closed both sides count as lit here, since it may itself be turned over; it is "
                   "called so where four fifths of what lies around its front are backs, and of what lies around its "
                   "back fronts. Sets are joined "
                   "by the edges that RL110 looks at. Without an emitter nothing is reported.",
            .fix = "radfix turns the set. If it is meant so, put a light on the side of its fronts.",
            .modeller = "SketchUp: Reverse Faces. Blender: Mesh > Normals > Flip. Rhino: Flip. Revit: the room is "
                        "bounded by the wrong side of its linings.",
            .limits = "Models in which faces cross or nearly touch have to be repaired first. Where light reaches both "
                      "sides of a set, nothing is decided (RL113)."},
    .check = &check,
};

}  // namespace rad::validate
