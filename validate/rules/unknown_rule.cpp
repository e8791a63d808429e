#include "validate/rules.h"

namespace rad::validate {

constinit const Rule unknown_rule{
    .id = "RL905",
    .alias = "unknown-rule",
    .title = "A rule is named that does not exist",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Fail,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A suppression, a baseline or a report names a rule that this version does not know.",
            .why = "What was meant to be silenced or compared is not. As a rule it is a slip of the pen, or a file of "
                   "a newer version.",
            .how = "The id or alias is neither in `radlint rules` nor a prefix of one there.",
            .fix = "Correct the name; the message says which is nearest.",
            .modeller = "Nothing to do in any modeller.",
            .limits = "On the command line and in radlint.toml an unknown rule is an error of use (exit code 2) and "
                      "not a finding."},
    .of_tool = true,
};

}  // namespace rad::validate
