#include <array>

#include "validate/material_uses.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"min-opacity", "1", 0.95, 0, 1, "opacity from which a material counts as opaque"},
};

double threshold(const Context& context) { return context.parameter(transparent_as_opaque, "min-opacity"); }

void check(const Context& context, Violations& out) {
  const double least = threshold(context);
  const auto at_fault = [&](const scene::Material& material) { return material.opacity < least || material.cut_out; };
  for_each_material_at_fault(context, at_fault, [&](const scene::Material& material, FaceId face) {
    out.add(material_violation(context, face, material.opacity));
  });
}

}  // namespace

constinit const Rule transparent_as_opaque{
    .id = "RL407",
    .alias = "transparent-as-opaque",
    .title = "Glass is solved as if it were opaque",
    .message =
        "{n} material{s} {lets|let} light through, with an opacity of {measure} at least, and {is|are} solved "
        "as opaque: {material}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .measure = {"opacity", MeasureUnit::Ratio, true},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "A material is transparent, or a picture cuts holes into it.",
            .why = "Faces block light in radiosity. A pane keeps the daylight out, a lamp behind its glass lights "
                   "nothing, and a leaf on a square throws the shadow of the square.",
            .how = "d below 0.95, or Tr above 0.05, or map_d in an MTL file; base colour alpha under alphaMode BLEND, "
                   "alphaMode MASK with a texture, or KHR_materials_transmission in glTF.",
            .fix = "Remove panes and lamp glasses from the model, or give the glass the emission of what shines "
                   "through it.",
            .modeller = "SketchUp: hide the layer of the glass before export. Revit: turn off the panes in Visibility. "
                        "Rhino, Blender: export without the glass objects.",
            .limits = "Alpha that only a texture holds is not seen under BLEND. Tr 1 without a d is taken for opaque, "
                      "since that is what programs that write it mean."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
