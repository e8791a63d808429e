#include "validate/rules.h"

namespace rad::validate {

constinit const Rule undecided{
    .id = "RL901",
    .alias = "undecided",
    .title = "Something could not be judged to the end",
    .message = "not judged to the end: {detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc =
        {.what = "A limit of time, memory or number was reached, or a value lies so near to its threshold that the "
                 "tolerance decides.",
         .why =
             "A model is not clean because nobody looked. What was not judged is named, so that nothing passes unseen.",
         .how = "Limits per file, and the caps of the search for contacts, which real models stay far below. radlint "
                "ends with exit code 3.",
         .fix = "Raise the limit, or judge the parts of the model on their own.",
         .modeller =
             "Blender, Rhino, SketchUp, Revit: export by layer or level, and hide what lies in itself many times over.",
         .limits = "Findings that are reported beside it are right; there may be more."},
    .of_tool = true,
};

}  // namespace rad::validate
