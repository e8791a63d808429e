#include "validate/rules.h"

namespace rad::validate {

constinit const Rule missing_resource{
    .id = "RL006",
    .alias = "missing-resource",
    .title = "A companion file is missing or may not be opened",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A material library or buffer that the model names is absent, or lies outside the model's folder.",
            .why = "Without the material library, reflectances and emitters are unknown: the solution has the wrong "
                   "brightness or no light at all.",
            .how =
                "Companions are looked for below the model's folder only; a path that leads out of it is not opened.",
            .fix = "Send the companion files along, in the folder of the model, with relative names.",
            .modeller = "Blender, Rhino and SketchUp write the .mtl beside the .obj: copy both. Revit exporters put "
                        "textures into a folder: copy it. For glTF choose the single-file GLB.",
            .limits = "Textures are not opened, so that a missing picture is not reported."},
    .reports = scene::ReadIssueKind::MissingResource,
};

}  // namespace rad::validate
