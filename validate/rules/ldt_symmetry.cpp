#include "validate/rules.h"

namespace rad::validate {

constinit const Rule ldt_symmetry{
    .id = "RL433",
    .alias = "ldt-symmetry",
    .title = "The planes of an EULUMDAT file do not go with its symmetry",
    .message = "{detail}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Error,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "The file names a symmetry, and lists other planes than that symmetry leaves, or planes that do "
                    "not make a turn.",
            .why = "Intensities are told apart by their number alone. With another number every plane that follows "
                   "is read in the wrong place.",
            .how = "Symmetry 0: all planes; 1: one; 2 and 3: half of them and one more; 4: a quarter and one more; "
                   "times the number of angles. The number of planes is divided by 2 or 4 where the symmetry asks "
                   "for it, and times their distance makes 360 degrees.",
            .fix = "Correct the symmetry (line 3), or the number of planes (line 4), whichever is wrong, or have "
                   "the file written anew.",
            .modeller = "Nothing to do in any modeller; the file is at fault.",
            .limits = "Where the count is right by chance the mistake is not seen."},
    .reports = scene::ReadIssueKind::PhotometrySymmetry,
};

}  // namespace rad::validate
