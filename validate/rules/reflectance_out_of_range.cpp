#include <algorithm>
#include <array>

#include "validate/material_uses.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-reflectance", "1", 0.95, 0.5, 1, "largest reflectance of a channel that a real surface has"},
};

double threshold(const Context& context) { return context.parameter(reflectance_out_of_range, "max-reflectance"); }

double darkest(const dvec3& colour) { return std::min({colour.x, colour.y, colour.z}); }

void check(const Context& context, Violations& out) {
  const double most = threshold(context);
  const auto at_fault = [&](const scene::Material& material) {
    return brightest(material.reflectance) > most || darkest(material.reflectance) < 0;
  };
  for_each_material_at_fault(context, at_fault, [&](const scene::Material& material, FaceId face) {
    const double high = brightest(material.reflectance), low = darkest(material.reflectance);
    Violation violation = material_violation(context, face, high > most ? high : low);
    violation.grave = high >= 1 || low < 0;
    out.add(violation);
  });
}

}  // namespace

constinit const Rule reflectance_out_of_range{
    .id = "RL401",
    .alias = "reflectance-out-of-range",
    .title = "A material reflects more than a real surface does",
    .message = "{n} material{s} with a reflectance outside 0 to {limit}, {measure} at worst: {material}",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .grave_at_solve = scene::Severity::Error,
    .measure = {"reflectance", MeasureUnit::Ratio},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 1",
    .doc = {.what = "A channel of the diffuse reflectance of a material in use is negative or above 0.95.",
            .why = "Light that bounces between such surfaces hardly fades: the solution is too bright and slow to "
                   "converge. From 1 on the sum of the bounces has no end, and there is no solution at all.",
            .how = "The largest and the smallest channel of Kd or of the base colour as it stands in the file, linear. "
                   "White paint reflects 0.85, fresh snow 0.9. Below 0 or from 1 on it is an error at stage solve.",
            .fix = "Give the material the reflectance that it has in the world: 0.8 for a white wall, 0.3 for wood, "
                   "0.2 for grey carpet.",
            .modeller =
                "Blender: Base Color of the material, value below 0.9. SketchUp: Edit Material, a light grey in place "
                "of pure white. Rhino: Materials, Diffuse colour. Revit: Material Browser, Appearance, Color.",
            .limits = "Many programs write white as 1 1 1 and mean about 0.8. A texture is not looked at."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
