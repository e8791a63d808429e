#include "validate/material_uses.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  const auto at_fault = [](const scene::Material& material) { return material.texture.has_value(); };
  for_each_material_at_fault(context, at_fault, [&](const scene::Material& material, FaceId face) {
    out.add(material_violation(context, face, brightest(material.reflectance)));
  });
}

}  // namespace

constinit const Rule texture_averaged{
    .id = "RL408",
    .alias = "texture-averaged",
    .title = "One reflectance stands for a whole picture",
    .message =
        "{n} textured material{s} {is|are} solved with one reflectance in place of the picture, at most "
        "{measure}: {material}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .measure = {"reflectance", MeasureUnit::Ratio},
    .fix = scene::FixClass::None,
    .citation = "baum91 2.1",
    .doc = {.what = "A material has a texture over its diffuse colour.",
            .why = "A surface of the paper has one material: light that bounces off it has one colour. Where the "
                   "picture has large light and dark parts, their light is mixed.",
            .how = "Every material in use with map_Kd or a base colour texture. The picture is not opened: Kd as "
                   "stated is the reflectance, or half of the base colour factor in glTF.",
            .fix = "Nothing is needed. Set Kd to the mean colour of the picture (linear) where it matters.",
            .modeller = "Blender, Rhino, SketchUp and Revit write Kd white or grey beside a texture: set the colour "
                        "of the material to the mean of the picture before export.",
            .limits = "Pictures that are of one colour are named too."},
    .check = &check,
};

}  // namespace rad::validate
