#include "validate/overlaps.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) { report_overlaps(context, OverlapKind::Hidden, out); }

}  // namespace

constinit const Rule hidden_coplanar{
    .id = "RL222",
    .alias = "hidden-coplanar",
    .title = "Faces touch front to front",
    .message = "{n} pair{s} of coplanar faces {looks|look} at each other{object}; the largest contact is {measure}",
    .requirement = Requirement::NoOverlappingFaces,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .measure = {"area in contact", MeasureUnit::Area},
    .citation = "baum91 2.1",
    .doc = {.what =
                "Two coplanar faces that look opposite ways cover the same place, such as the bottom of a box and the "
                "desk it stands on.",
            .why =
                "Harmless: from either side exactly one front exists. Counted because it costs patches that no light "
                "reaches, and because the outline of the contact has to be drawn into the larger face (RL211).",
            .how = "As for RL220, with opposite facing, unless the faces are twins (RL114).",
            .fix = "Nothing is required.",
            .modeller = "Nothing to do in any modeller.",
            .limits =
                "Whether the two fronts are buried (two solids) or both seen (a sheet with two sides) is not decided."},
    .check = &check,
};

}  // namespace rad::validate
