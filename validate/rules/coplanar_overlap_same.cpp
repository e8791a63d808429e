#include "validate/overlaps.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_overlaps(context, OverlapKind::SameMaterial, out); }

}  // namespace

constinit const Rule coplanar_overlap_same{
    .id = "RL220",
    .alias = "coplanar-overlap-same",
    .title = "Coplanar faces of one material overlap",
    .message =
        "{n} pair{s} of coplanar faces of one material {overlaps|overlap}{object}; the largest overlap is {measure}",
    .requirement = Requirement::NoOverlappingFaces,
    .measure = {"overlapping area", MeasureUnit::Area},
    .fix = scene::FixClass::Safe,
    .fix_operation = "coplanar",
    .citation = "baum91 2.1, 3.3",
    .doc = {.what = "Two faces of the same material lie in one plane, look the same way and cover the same place.",
            .why =
                "The place counts twice: it receives and radiates double energy, and which of the two is seen changes "
                "from pixel to pixel.",
            .how =
                "Normals within 2.6 degrees, distance at the middle of the overlap at most T, and an overlap that is "
                "more than T/2 wide on average. Faces that are equal corner for corner are included.",
            .fix = "radfix cuts both along their outlines and keeps one of the coinciding pieces (Coplanar).",
            .modeller = "SketchUp: explode and intersect faces, then erase the doubled one. Blender: Merge by Distance "
                        "after joining. Rhino: SelDup. Revit: check joined walls and floors exported twice.",
            .limits = "A narrower overlap is noise and is not reported here; RL302 and RL201 name its corners."},
    .check = &check,
};

}  // namespace rad::validate
