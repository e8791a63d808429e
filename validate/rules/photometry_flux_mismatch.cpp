#include "validate/rules.h"

namespace rad::validate {

constinit const Rule photometry_flux_mismatch{
    .id = "RL431",
    .alias = "photometry-flux-mismatch",
    .title = "Luminous intensities do not add up to the flux that is stated",
    .message = "{detail}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "The integral of the intensities over all directions is not the flux that the same file states.",
            .why = "One of the two is wrong, mostly by a factor: a multiplier that was left out, lumens of one lamp"
                   " for all, intensities per 1000 lumens. The room comes out too bright or too dark by it.",
            .how = "Intensities are linear between angles, and planes that symmetry leaves out are those that stand"
                   " for them. IES: more than 1.05 times the lumens of all lamps; less is what the luminaire keeps,"
                   " and -1 lumens states nothing. EULUMDAT: more than a twentieth off the light output ratio; "
                   "files with a negative number of lamps state none.",
            .fix = "Compare with the data sheet of the luminaire: its flux, and whether the intensities are "
                   "absolute.",
            .modeller = "Revit: Initial Intensity of the light source overrides the file. Blender: the strength of the "
                        "IES texture node. Rhino and SketchUp renderers have a factor of their own.",
            .limits = "Coarse angles near a narrow beam can put the integral off by some percent."},
    .reports = scene::ReadIssueKind::FluxMismatch,
};

}  // namespace rad::validate
