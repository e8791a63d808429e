#include <array>

#include "validate/material_uses.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"min-specular", "1", 0.05, 0, 1, "specular reflectance up to which a surface counts as diffuse"},
};

double threshold(const Context& context) { return context.parameter(specular_dropped, "min-specular"); }

void check(const Context& context, Violations& out) {
  const double least = threshold(context);
  const auto at_fault = [&](const scene::Material& material) { return brightest(material.specular) > least; };
  for_each_material_at_fault(context, at_fault, [&](const scene::Material& material, FaceId face) {
    out.add(material_violation(context, face, brightest(material.specular)));
  });
}

}  // namespace

constinit const Rule specular_dropped{
    .id = "RL406",
    .alias = "specular-dropped",
    .title = "Shine is left out of a diffuse solution",
    .message =
        "{n} material{s} {reflects|reflect} up to {measure} like a mirror, which a diffuse solution leaves "
        "out: {material}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .measure = {"specular reflectance", MeasureUnit::Ratio},
    .fix = scene::FixClass::None,
    .citation = "baum91 1",
    .doc = {.what = "A material has a specular colour or is a metal.",
            .why = "Radiosity knows diffuse reflection only: the light that such a surface mirrors is missing in the "
                   "solution. A room with a polished floor comes out darker than it is.",
            .how = "The largest channel of Ks (where illum allows highlights), or of the base colour times "
                   "metallicFactor, above 0.05: 5 % is about what every dielectric mirrors.",
            .fix = "Nothing, or raise the diffuse reflectance by the share of the light that is to stay in the room.",
            .modeller = "Blender: Metallic and Specular of the Principled BSDF; its OBJ exporter writes Ks 0.5 for "
                        "every material. SketchUp, Rhino, Revit: reflectivity of the material.",
            .limits = "Many exporters write the same Ks for all materials, whether they shine or not. Metalness that "
                      "a texture holds is not seen."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
