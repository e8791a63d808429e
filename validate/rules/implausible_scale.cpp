#include <array>

#include "validate/plausible_units.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"min-size", "m", 0.5, 0, 1e6, "least diagonal of a plausible model"},
    Parameter{"max-size", "m", 5000, 0, 1e9, "largest diagonal of a plausible model"},
};

void check(const Context& context, Violations& out) {
  if (!context.scene.metres_per_unit || context.topology.components.empty()) return;
  const double metres = *context.scene.metres_per_unit;
  const SizeEvidence evidence = size_evidence(context);
  const double diagonal = evidence.diagonal * metres;
  const bool too_small = diagonal < context.parameter(implausible_scale, "min-size");
  const bool too_large = diagonal > context.parameter(implausible_scale, "max-size");
  if (!too_small && !too_large && !is_contradicted(evidence, metres)) return;
  const UnitGuesses guesses = plausible_units(evidence);
  const std::string more =
      guesses.best.metres == metres ? std::string("no other unit is more plausible") : words_of(evidence, guesses);
  out.add({.measure = evidence.diagonal,
           .cluster = kWholeModel,
           .detail = out.keep(metric_length(diagonal) + " across; " + more)});
}

}  // namespace

constinit const Rule implausible_scale{
    .id = "RL502",
    .alias = "implausible-scale",
    .title = "The model is not of a plausible size in its unit",
    .message = "implausible size in the unit that is declared: {detail}",
    .requirement = Requirement::Units,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"diagonal", MeasureUnit::Length},
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "In the unit that the file or --units declares, the model is smaller than half a metre or larger "
                    "than 5 km, or its doors, chairs, beds, tables or windows are of a size that there is not.",
            .why = "A wrong unit makes rooms of the size of a hand: patch sizes and light in physical units are then "
                   "off by a thousand and more.",
            .how = "The diagonal of the box of all faces, in metres. The largest part of objects that are named after "
                   "a thing of known size is held against that size: reported beyond the fourth power of the factor by "
                   "which such things differ (doors: 1.3).",
            .fix = "Export in the right unit, or say it with --units. The most plausible unit and the next are named.",
            .modeller = "Blender: Scene > Units, and apply the scale of objects (Ctrl+A). SketchUp: unit in the export "
                        "options. Rhino: Units, scale the model. Revit: unit in the export options.",
            .limits = "Single fixtures below half a metre and whole cities are reported; set min-size and max-size."},
    .parameters = kParameters,
    .check = &check,
};

}  // namespace rad::validate
