#include "validate/rules.h"

namespace rad::validate {

constinit const Rule unsupported_content{
    .id = "RL010",
    .alias = "unsupported-content",
    .title = "Content that is not a surface was left out",
    .message = "{n} occurrence{s} left out: {detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .citation = "",
    .doc = {.what =
                "The file holds points, lines, curves, skins, animations or the like, which have no surface to judge.",
            .why = "Radiosity is computed on faces. Content that is left out neither blocks nor reflects light.",
            .how = "Every kind of content that is passed over is counted once for the file.",
            .fix = "Nothing, if the content is auxiliary. Curves and freeform surfaces must be exported as meshes.",
            .modeller = "Rhino: choose polygon mesh in the OBJ export options. Blender: apply modifiers and convert "
                        "curves to meshes before exporting. SketchUp: untick edges and construction lines. Revit: "
                        "export 3D views without lines and text.",
            .limits = "None known."},
    .reports = scene::ReadIssueKind::UnsupportedContent,
};

}  // namespace rad::validate
