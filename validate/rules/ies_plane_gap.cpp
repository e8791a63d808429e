#include "validate/rules.h"

namespace rad::validate {

constinit const Rule ies_plane_gap{
    .id = "RL432",
    .alias = "ies-plane-gap",
    .title = "Luminous intensities leave directions out",
    .message = "{detail}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "Planes or angles of measurement do not make a quarter, half or whole turn, or planes are more "
                    "than a right angle apart.",
            .why = "What symmetry does not explain is nowhere stated. Programs fill the gap in different ways: with"
                   " darkness, with the nearest plane, or by mirroring what should not be mirrored.",
            .how = "Type C: horizontal angles from 0 to 0, 90, 180 or 360, or from 90 to 270; vertical ones from "
                   "the nadir or the horizon to the horizon or the zenith. Types A and B: from -90 or 0 to 90. "
                   "EULUMDAT: from the nadir at least to the horizon. To a hundredth of a degree.",
            .fix = "Add the planes that are missing; very often it is the last, which repeats the first at 360 "
                   "degrees.",
            .modeller =
                "Revit, Rhino, Blender and SketchUp show the shape of the light: look for a slice that is dark.",
            .limits = "None known."},
    .reports = scene::ReadIssueKind::PlaneGap,
};

}  // namespace rad::validate
