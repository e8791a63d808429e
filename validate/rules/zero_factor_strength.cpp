#include "validate/material_uses.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  const auto at_fault = [](const scene::Material& material) { return material.emission_cancelled; };
  for_each_material_at_fault(context, at_fault,
                             [&](const scene::Material&, FaceId face) { out.add(material_violation(context, face)); });
}

}  // namespace

constinit const Rule zero_factor_strength{
    .id = "RL405",
    .alias = "zero-factor-strength",
    .title = "A light is multiplied by zero",
    .message = "{n} material{s} {states|state} a light and {multiplies|multiply} it by 0: {material}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A material has an emissive texture or an emissive strength, and a factor of 0 that puts it out.",
            .why = "The lamp looks finished in the material list and stays dark in the solution.",
            .how = "glTF: emissiveTexture, or KHR_materials_emissive_strength above 1, with an emissiveFactor of 0, "
                   "which is what it is where nothing is stated; or a factor above 0 with a strength of 0. OBJ: "
                   "map_Ke without a Ke above 0.",
            .fix = "State the colour of the light (emissiveFactor, Ke) beside its picture or strength.",
            .modeller = "Blender: Emission Color not black and Strength above 0. Rhino: Emission colour of the "
                        "material. SketchUp and Revit: edit the exported file.",
            .limits = "A picture that is black everywhere is not noticed. A light that was switched off on purpose by "
                      "its factor is reported."},
    .check = &check,
};

}  // namespace rad::validate
