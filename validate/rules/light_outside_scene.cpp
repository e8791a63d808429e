#include <algorithm>
#include <array>

#include "validate/component_members.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-distance", "diagonals", 1, 0, 1000, "how far from the rest of the model a light may be"},
};

double threshold(const Context& context) { return context.parameter(light_outside_scene, "max-distance"); }

geom::Box box_of_face(const Context& context, FaceId id) {
  geom::Box box;
  for (const PointId p : context.model.corners_of(context.scene.loops[context.scene.faces[id].first_loop])) {
    if (p != scene::kNoPoint) box.add(context.position(p));
  }
  return box;
}

// Largest gap along an axis.
double distance_between(const geom::Box& a, const geom::Box& b) {
  double gap = 0;
  for (int axis = 0; axis < 3; ++axis) gap = std::max({gap, a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]});
  return gap;
}

geom::Box box_of_unlit(const Context& context) {
  geom::Box box;
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (context.scene.materials[context.material_of(id)].emits()) continue;
    const geom::Box own = box_of_face(context, id);
    if (own.empty()) continue;
    box.add(own.low);
    box.add(own.high);
  }
  return box;
}

void check(const Context& context, Violations& out) {
  const auto& materials = context.scene.materials;
  if (std::ranges::none_of(materials, &scene::Material::emits)) return;
  const geom::Box rest = box_of_unlit(context);
  if (rest.empty() || rest.diagonal() == 0) return;
  const double most = threshold(context);
  for (FaceId id = 0; id < context.scene.faces.size(); ++id) {
    if (!materials[context.material_of(id)].emits() || !context.is_sound(id)) continue;
    const double diagonals = distance_between(box_of_face(context, id), rest) / rest.diagonal();
    if (diagonals <= most) continue;
    out.add({.faces = {id, kNoFace}, .point = context.centre(id), .measure = diagonals, .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule light_outside_scene{
    .id = "RL421",
    .alias = "light-outside-scene",
    .title = "A light is far from all that it could light",
    .message = "{n} emitting face{s} far from all else{object}, by {measure} diagonals of the rest",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"distance over diagonal", MeasureUnit::Ratio},
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {.what = "A face that emits light is farther from everything that does not than the model is large.",
            .why = "Almost all of its light is lost, and patches and the tolerance are made for a scene that is mostly "
                   "empty. As a rule a lamp was left where it was drawn, or is in another unit.",
            .how = "The gap between the box of the face and the box of all faces that do not emit, along an axis, "
                   "above one diagonal of the latter.",
            .fix = "Move the lamp to its place, or delete it.",
            .modeller = "SketchUp: Zoom Extents shows it. Rhino: ZoomExtents All. Blender: View > Frame All. Revit: "
                        "look in a 3D view without a section box.",
            .limits = "A sky or sun that is modelled as a distant panel is reported."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
