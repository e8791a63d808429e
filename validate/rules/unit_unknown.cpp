#include "validate/plausible_units.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  if (context.scene.metres_per_unit || context.topology.components.empty()) return;
  const SizeEvidence evidence = size_evidence(context);
  out.add({.cluster = kWholeModel, .detail = out.keep(words_of(evidence, plausible_units(evidence)))});
}

}  // namespace

constinit const Rule unit_unknown{
    .id = "RL501",
    .alias = "unit-unknown",
    .title = "The file does not say what unit its lengths are in",
    .message = "no unit of length is declared (say --units), and a solve takes metres; {detail}",
    .requirement = Requirement::Units,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .fix = scene::FixClass::None,
    .citation = "",
    .doc = {.what = "The format has no unit (OBJ, STL, PLY, OFF), no comment at the head of the file names one, and "
                    "--units was not given.",
            .why = "Radiosity itself does not hang on it, but all that is stated in metres does: patch sizes, light in "
                   "W/m², and how large the model stands in a viewer. A guess that nobody saw is worse than none.",
            .how = "The unit is declared by glTF (metres), by a comment such as \"# units: mm\" before the first "
                   "vertex of an OBJ, or by --units. For the most plausible one the model is measured: its diagonal, "
                   "and doors, chairs, beds, tables or windows where objects are so named, else its median part. The "
                   "next best is named beside it. Nothing is done with the guess.",
            .fix = "Say --units m, cm, mm, in or ft, or set units in radlint.toml.",
            .modeller = "SketchUp: choose the unit in the OBJ export options and say the same to --units. Blender: "
                        "exports metres unless Scale is set. Rhino: Units shows it. Revit: exports feet or "
                        "millimetres, as the exporter says.",
            .limits = "The guess is made for rooms and houses; a city or a screw is taken for what it is not."},
    .check = &check,
};

}  // namespace rad::validate
