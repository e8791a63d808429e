#include "validate/rules.h"

namespace rad::validate {

constinit const Rule ies_syntax{
    .id = "RL430",
    .alias = "ies-syntax",
    .title = "A file of luminous intensities does not follow its format",
    .message = "{detail}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Error,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A file in the format IES LM-63 or EULUMDAT lacks a number, has one too many, or has one that "
                    "cannot be there.",
            .why = "A program that reads on regardless takes an angle for an intensity: the lamp then lights the "
                   "room as nobody measured it.",
            .how = "Keywords up to TILT=, ten figures, three reserved ones, angles that ascend, as many intensities"
                   " as the counts say, none below zero. EULUMDAT: a value a line in its fixed order. Numbers above"
                   " 1e8 are not believed.",
            .fix = "Get the file from the maker of the luminaire again, or have it written anew by a program for "
                   "photometry.",
            .modeller = "Revit, Rhino, Blender and SketchUp take the file as it is, and say little about what is wrong "
                        "with it.",
            .limits = "Keywords are not judged, only the numbers after them. The solver of radfix does not read "
                      "photometry; materials state its light."},
    .reports = scene::ReadIssueKind::PhotometrySyntax,
};

}  // namespace rad::validate
