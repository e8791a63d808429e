#include "validate/overlaps.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_overlaps(context, OverlapKind::DifferentMaterial, out); }

}  // namespace

constinit const Rule coplanar_overlap_diff{
    .id = "RL221",
    .alias = "coplanar-overlap-diff",
    .title = "Coplanar faces of different materials overlap",
    .message =
        "{n} pair{s} of coplanar faces of different materials {overlaps|overlap}{object}; the largest overlap is "
        "{measure}",
    .requirement = Requirement::NoOverlappingFaces,
    .measure = {"overlapping area", MeasureUnit::Area},
    .fix = scene::FixClass::Safe,
    .fix_operation = "coplanar",
    .citation = "baum91 3.3",
    .doc = {.what = "Two faces of different materials lie in one plane, look the same way and cover the same place: a "
                    "sheet of paper on a desk.",
            .why = "It is unclear which one is seen and which one reflects; both cannot.",
            .how = "As for RL220, with different materials.",
            .fix = "radfix keeps the piece of the surface that emits light, or else of the smaller one, as the paper "
                   "proposes, and counts the pieces that it removes (Coplanar).",
            .modeller = "SketchUp: draw the outline of the smaller face into the larger one and paint it. Revit: Split "
                        "Face and Paint. Rhino: Split the face by the outline. Blender: Knife Project the outline. In "
                        "none of them lift one face by a hair: that only trades this fault for a shadow leak.",
            .limits = "The choice of the winner is a heuristic: look at the result."},
    .check = &check,
};

}  // namespace rad::validate
