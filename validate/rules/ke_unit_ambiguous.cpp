#include "validate/material_uses.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  const auto at_fault = [](const scene::Material& material) {
    return material.emits() && material.emission_unit == scene::Material::EmissionUnit::Exitance;
  };
  for_each_material_at_fault(context, at_fault, [&](const scene::Material& material, FaceId face) {
    out.add(material_violation(context, face, brightest(material.emission)));
  });
}

}  // namespace

constinit const Rule ke_unit_ambiguous{
    .id = "RL404",
    .alias = "ke-unit-ambiguous",
    .title = "The format does not say what unit its light is in",
    .message =
        "Ke of {n} emitting material{s} has no unit; it is taken for an exitance in W/m², at most {measure}: "
        "{material}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Review,
    .measure = {"exitance", MeasureUnit::Ratio},
    .fix = scene::FixClass::None,
    .citation = "",
    .doc = {.what = "Materials of an OBJ emit light, and MTL does not say in what unit.",
            .why = "Exporters write radiance, exitance, or a colour between 0 and 1: results differ by π and more. "
                   "Their proportions are right in any case.",
            .how = "Every emitting material of an MTL file that a face uses. Ke is taken for the radiant exitance in "
                   "W/m² of each channel.",
            .fix = "Nothing where only the proportions of the light count; else scale Ke to W/m², or export glTF, "
                   "which has a unit (cd/m²).",
            .modeller = "Blender: its OBJ exporter writes emission colour times strength, in W/m² as it comes. Rhino, "
                        "SketchUp and Revit write a colour from 0 to 1.",
            .limits = "The note stands whether or not the values are right."},
    .check = &check,
};

}  // namespace rad::validate
