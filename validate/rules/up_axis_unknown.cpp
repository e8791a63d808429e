#include <cmath>
#include <glm/geometric.hpp>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

// Cosine of 1 degree: level for what stands on it.
constexpr double kLevel = 0.9998476951563913;
// One axis is named only where it has so much more level area than the other.
constexpr double kClearlyMore = 1.5;

// Areas of faces that are level if y or z points up.
struct LevelAreas {
  double y = 0;
  double z = 0;
};

LevelAreas level_areas(const Context& context) {
  LevelAreas areas;
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!context.is_sound(id)) continue;
    const dvec3& normal = context.triangles.normal[id];
    const double size = glm::length(normal);
    if (std::abs(normal.y) > kLevel * size) areas.y += size;
    if (std::abs(normal.z) > kLevel * size) areas.z += size;
  }
  return areas;
}

std::string_view guess(const LevelAreas& areas) {
  if (areas.z > kClearlyMore * areas.y) return "z is more plausible, with more level area than y";
  if (areas.y > kClearlyMore * areas.z) return "y is more plausible, with more level area than z";
  return "y and z are about as plausible";
}

void check(const Context& context, Violations& out) {
  if (context.scene.up != scene::UpAxis::Unknown || context.topology.components.empty()) return;
  out.add({.cluster = kWholeModel, .detail = guess(level_areas(context))});
}

}  // namespace

constinit const Rule up_axis_unknown{
    .id = "RL505",
    .alias = "up-axis-unknown",
    .title = "The file does not say which way is up",
    .message = "no up axis is declared (say --up); {detail}",
    .requirement = Requirement::Units,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Review,
    .fix = scene::FixClass::None,
    .citation = "",
    .doc = {.what = "The format has no up axis (OBJ, STL, PLY, OFF), and --up was not given.",
            .why = "Light does not care, but pictures and viewers do: glTF has y up, and a model with z up lies on its "
                   "back in it unless radfix is told.",
            .how = "glTF declares y. For the others the areas of faces that would be level are compared: the axis with "
                   "at least half as much again is called more plausible. Nothing is done with the guess.",
            .fix = "Say --up y or --up z, or set up in radlint.toml.",
            .modeller = "Blender: Up Axis of the export (OBJ: Y unless changed). SketchUp: z up unless \"swap YZ\" "
                        "is on. Rhino: \"Map Rhino Z to OBJ Y\". Revit: z up.",
            .limits = "A model without floors and ceilings tells nothing."},
    .check = &check,
};

}  // namespace rad::validate
