#include "validate/rules.h"

namespace rad::validate {

constinit const Rule unused_suppression{
    .id = "RL903",
    .alias = "unused-suppression",
    .title = "A suppression suppresses nothing",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Fail,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A comment in a model, or an entry of the file beside it, silences a rule in a place where it "
                    "finds nothing.",
            .why = "The next fault in that place would be silenced by a suppression that nobody remembers.",
            .how =
                "Every suppression is matched with the findings of the run; those that match none are reported where "
                "they stand.",
            .fix = "Delete the suppression.",
            .modeller = "Comments in an OBJ are lost with the next export from SketchUp, Revit, Rhino or Blender: keep "
                        "suppressions in the sidecar.",
            .limits =
                "Where one of the rules that a suppression names is not checked, or the model was not judged to the "
                "end, nothing is said. Entries of radlint.toml are not judged: they speak of many models."},
    .of_tool = true,
};

}  // namespace rad::validate
