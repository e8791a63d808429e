#include "validate/maximal_planes.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_seams(context, false, out); }

}  // namespace

constinit const Rule not_maximal_planar{
    .id = "RL120",
    .alias = "not-maximal-planar",
    .title = "Coplanar neighbours are not one face",
    .message = "{n} seam{s} between coplanar faces of one material{object}; the longest is {measure}",
    .requirement = Requirement::MaximalPlanarFaces,
    .severity = scene::Severity::Warning,
    .note_where_triangles_only = true,
    .measure = {"length of the seam", MeasureUnit::Length},
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 3, 3.1",
    .doc = {.what =
                "Two faces of one object and material that share an edge lie in one plane: the modeller has split a "
                "face that belongs together.",
            .why = "Every needless edge constrains the mesh, and pieces that are meshed on their own leave T-vertices "
                   "and visible seams along it (the ground of Color Plate 1).",
            .how = "All corners of the smaller face within T of the larger one's plane, and no third face, contact or "
                   "intersection on the edge. Where the texture coordinates of both are not one affine map the seam is "
                   "needed (RL121). A note in formats that can hold triangles only.",
            .fix = "radfix merges them into one face with holes, in a model that needs repair and always before it "
                   "meshes (Grouper).",
            .modeller = "SketchUp: erase the coplanar edges. Blender: Limited Dissolve. Rhino: MergeAllCoplanarFaces. "
                        "Revit: nothing to do, exporters triangulate.",
            .limits = "Gently curved surfaces whose facets lie within T of each other are reported as well."},
    .check = &check,
};

}  // namespace rad::validate
