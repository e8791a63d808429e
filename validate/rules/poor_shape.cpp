#include <array>

#include "validate/face_shape.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"min-shape", "1", 0.20, 0, 1, "least scaled ρ of a face that is well shaped"},
};

double threshold(const Context& context) { return context.parameter(poor_shape, "min-shape"); }

void check(const Context& context, Violations& out) {
  const double least = threshold(context);
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!context.is_sound(id) || !is_triangle_or_convex_quad(context, id)) continue;
    const double shape = scaled_shape(context, id);
    if (shape >= least) continue;
    out.add({.faces = {id, kNoFace}, .point = context.centre(id), .measure = shape, .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule poor_shape{
    .id = "RL240",
    .alias = "poor-shape",
    .title = "A triangle or quadrilateral is a needle or sliver",
    .message = "{n} face{s} of poor shape{object}; the worst has ρ = {measure} (at least {limit}, 1 is best)",
    .requirement = Requirement::WellShapedFaces,
    .measure = {"scaled ρ", MeasureUnit::Ratio, true},
    .fix = scene::FixClass::Safe,
    .fix_operation = "pmesh",
    .citation = "baum91 2.2",
    .doc = {.what = "The ratio of inscribed to circumscribed circle of a triangle or convex quadrilateral is small.",
            .why =
                "Form factors to such faces are approximated badly, and their nodes are spent where they do not help. "
                "In a model it does not matter, since the faces are meshed anew.",
            .how =
                "ρ = r/R, scaled so that the equilateral triangle and the square score 1; for a quadrilateral r is the "
                "largest inscribed and R the smallest enclosing circle. Below 0.20: needles under about 6 degrees, "
                "rectangles longer than about 7 to 1.",
            .fix = "Nothing in a model: radfix --mesh makes well-shaped patches (Pmesh).",
            .modeller = "Nothing to do in any modeller; triangulations of large faces are full of needles.",
            .limits = "Faces with more corners are not measured."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
