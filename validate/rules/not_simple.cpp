#include "validate/face_shape.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!context.is_sound(id) || is_triangle_or_convex_quad(context, id)) continue;
    out.add({.faces = {id, kNoFace},
             .point = context.centre(id),
             .measure = static_cast<double>(corner_count(context, id)),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule not_simple{
    .id = "RL230",
    .alias = "not-simple",
    .title = "A face is not a triangle or convex quadrilateral",
    .message = "{n} face{s} not a triangle or convex quadrilateral{object}; up to {measure} corners",
    .requirement = Requirement::SimpleFaces,
    .measure = {"corners", MeasureUnit::Count},
    .fix = scene::FixClass::Safe,
    .fix_operation = "pmesh",
    .citation = "baum91 2.2",
    .doc = {.what = "A face has more than four corners, a reflex corner, or holes.",
            .why =
                "The solution is interpolated over triangles and convex quadrilaterals. In a model general faces are "
                "right and welcome; in a mesh they are not.",
            .how = "Exact convexity in the projection along the face's dominant axis; corners in line count as not "
                   "strictly convex.",
            .fix = "Nothing in a model: radfix --mesh makes triangles and convex quadrilaterals of it (Pmesh).",
            .modeller = "Nothing to do in any modeller.",
            .limits = "None known."},
    .check = &check,
};

}  // namespace rad::validate
