#include "validate/rules.h"

namespace rad::validate {

constinit const Rule truncated{
    .id = "RL902",
    .alias = "truncated",
    .title = "Not all findings are listed",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A report lists fewer findings than there are.",
            .why = "Counts and the verdict are of all findings; only the list is short.",
            .how = "The limit is --max-issues for each rule; code scanning services have limits of their own.",
            .fix = "Raise --max-issues, or repair what is listed first.",
            .modeller = "Nothing to do in any modeller.",
            .limits = "None known."},
    .of_tool = true,
};

}  // namespace rad::validate
