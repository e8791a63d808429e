#include "validate/maximal_planes.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_seams(context, true, out); }

}  // namespace

constinit const Rule merge_blocked{
    .id = "RL121",
    .alias = "merge-blocked",
    .title = "Texture coordinates keep coplanar neighbours apart",
    .message =
        "{n} seam{s} between coplanar faces of one material {is|are} kept for the texture{object}; the longest "
        "is {measure}",
    .requirement = Requirement::MaximalPlanarFaces,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .measure = {"length of the seam", MeasureUnit::Length},
    .citation = "baum91 3, 3.1",
    .doc =
        {.what = "Two faces of one object and material that share an edge lie in one plane, but their texture "
                 "coordinates do not go on from one to the other.",
         .why = "As one face they would lose the seam of the texture. The edge stays, and constrains the mesh there.",
         .how = "As for RL120, where one affine map through the corners of the larger face does not give the texture "
                "coordinates of both: off by more than 2^-13, half a texel of an image 4096 texels wide, and by more "
                "than the image moves over T.",
         .fix = "Nothing is required. radfix keeps the faces apart.",
         .modeller =
             "Map the texture over the whole plane at once, where that is meant. Blender: select the coplanar faces, "
             "then UV > Project from View. SketchUp: Texture > Projected. Rhino: planar mapping. Revit: nothing to do.",
         .limits = "Coordinates that differ by a whole number show the same place of a repeated image, and count as "
                   "different. Whether the material has an image is not looked at."},
    .check = &check,
};

}  // namespace rad::validate
