#include "validate/context.h"
#include "validate/overlaps.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_overlaps(context, OverlapKind::Twin, out); }

}  // namespace

constinit const Rule double_sided_duplicate{
    .id = "RL114",
    .alias = "double-sided-duplicate",
    .title = "A face has a twin that looks the other way",
    .message = "{n} face{s} doubled back to back{object}; the largest has {measure}",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"area", MeasureUnit::Area},
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "merge-twins",
    .citation = "baum91 2.1",
    .doc =
        {.what = "Two faces of one object and material have the same corners and look opposite ways: a modeller's way "
                 "of drawing a two-sided sheet.",
         .why = "Each side is one-sided and right in itself, but the number of faces doubles, and a solid whose faces "
                "are all doubled has no inside.",
         .how = "The outlines have the same vertices (at lattice precision) and opposite facing.",
         .fix = "Keep both where both sides are seen; otherwise delete the one that is not.",
         .modeller =
             "SketchUp: untick two-sided faces in the export options. Blender: Select > All by Trait > Interior Faces. "
             "Rhino: untick double-sided mesh. Revit: give thin families a thickness, and export one side only.",
         .limits =
             "Sheets whose two sides are meshed differently or belong to different objects are reported as RL222."},
    .check = &check,
};

}  // namespace rad::validate
