#include "validate/rules.h"

namespace rad::validate {

constinit const Rule stale_baseline{
    .id = "RL904",
    .alias = "stale-baseline",
    .title = "A baseline lists findings that are gone",
    .message = "{detail}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Fail,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "The baseline names findings that the model does not have any more.",
            .why = "It would let the same fault pass when it comes back.",
            .how = "Findings are matched by their place and not by line or number; entries that match none are stale.",
            .fix = "Run radlint with --prune-baseline and commit the file.",
            .modeller = "Nothing to do in any modeller.",
            .limits = "Entries of files that were not judged in this run are not stale."},
    .of_tool = true,
};

}  // namespace rad::validate
