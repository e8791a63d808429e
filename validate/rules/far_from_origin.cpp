#include <array>
#include <cmath>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-spacing", "T", 0.25, 0.001, 1000, "spacing of 32-bit floats at the model that is still fine enough"},
};

// A model that contains the origin, or touches it, is never farther away than this.
constexpr double kNearDiagonals = 2;

double threshold(const Context& context) {
  return context.parameter(far_from_origin, "max-spacing") * context.tolerance.length;
}

// Distance of neighbouring 32-bit floats.
double float_spacing(double magnitude) {
  constexpr int kMantissaBits = 23;
  return std::ldexp(1.0, std::ilogb(magnitude) - kMantissaBits);
}

void check(const Context& context, Violations& out) {
  const geom::Box& box = context.model.box;
  if (box.empty()) return;
  const double magnitude = box.largest_magnitude();
  if (magnitude <= kNearDiagonals * context.tolerance.diagonal || magnitude == 0) return;
  const double spacing = float_spacing(magnitude);
  const bool sets_tolerance = context.tolerance.source == geom::ToleranceSource::SinglePrecision;
  if (!sets_tolerance && spacing <= threshold(context)) return;
  out.add({.point = (box.low + box.high) * 0.5, .measure = spacing, .cluster = kWholeModel});
}

}  // namespace

constinit const Rule far_from_origin{
    .id = "RL503",
    .alias = "far-from-origin",
    .title = "The model lies so far from the origin that single precision is too coarse",
    .message = "far from the origin: there 32-bit floats are {measure} apart (at most {limit} would do)",
    .requirement = Requirement::Units,
    .severity = scene::Severity::Warning,
    .measure = {"spacing of floats", MeasureUnit::Length},
    .fix = scene::FixClass::Manual,
    .citation = "segal90",
    .doc = {.what = "The coordinates are so large, compared with the model, that 32-bit floats cannot tell points "
                    "apart that the tolerance tells apart.",
            .why = "glTF, STL and every graphics card hold coordinates in 32-bit floats: vertices jump, faces flicker, "
                   "and the tolerance has to be coarser than the model asks for. National grid coordinates do this.",
            .how = "The distance between neighbouring 32-bit floats at the largest coordinate is above T/4, or, in a "
                   "format that stores such floats, it is what T had to be made from. Nothing within two diagonals of "
                   "the origin is reported.",
            .fix = "Move the model to the origin and note the offset. radfix works on a lattice around the model and "
                   "loses nothing, but a GLB or STL that it writes has the same floats.",
            .modeller = "Revit: export with the internal origin or project base point, not shared coordinates. Rhino: "
                        "Move to 0. SketchUp: Reset the axes and move. Blender: clear the location of objects.",
            .limits = "Files in double precision that stay in double precision are reported too."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
