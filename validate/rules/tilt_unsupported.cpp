#include "validate/rules.h"

namespace rad::validate {

constinit const Rule tilt_unsupported{
    .id = "RL434",
    .alias = "tilt-unsupported",
    .title = "Luminous intensities hang on the tilt of the lamp",
    .message = "{detail}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "The file says by TILT= that its lamp gives another flux when the luminaire is tilted, in a list"
                    " or in another file.",
            .why = "Programs that read photometry mostly pass over it, and light the room as if the luminaire hung "
                   "straight.",
            .how = "TILT=INCLUDE or a name of a file in place of TILT=NONE.",
            .fix = "Nothing, where the luminaire hangs as it was measured. Else scale its light by the factor of "
                   "the list.",
            .modeller = "Nothing to do in any modeller.",
            .limits = "The list itself is checked for its numbers only, a file that it stands in not at all."},
    .reports = scene::ReadIssueKind::TiltUnsupported,
};

}  // namespace rad::validate
