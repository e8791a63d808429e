#include "validate/rules.h"

namespace rad::validate {

constinit const Rule unknown_rule{
    .id = "RL905",
    .alias = "unknown-rule",
    .title = "A suppression names no rule that there is",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Fail,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A comment to radlint in a model, or the file of suppressions beside it, names a rule that this "
                    "version does not know, or cannot be understood.",
            .why = "What was meant to be silenced is not. As a rule it is a slip of the pen, or a file of a newer "
                   "version.",
            .how = "The id or alias is neither in `radlint rules` nor a prefix of one there; or the comment is not of "
                   "the form `radlint: ignore[RL221] reason`, or the file beside the model is no TOML of the keys that "
                   "docs/configuration.md lists.",
            .fix = "Correct it; the message says what is nearest.",
            .modeller = "Nothing to do in any modeller.",
            .limits = "On the command line and in radlint.toml an unknown rule is an error of use (exit code 2) and "
                      "not a finding."},
    .of_tool = true,
};

}  // namespace rad::validate
