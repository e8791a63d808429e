#include <algorithm>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  const auto& faces = context.scene.faces;
  const bool any = std::ranges::any_of(
      faces, [&](const scene::Face& face) { return context.scene.materials[face.material].emits(); });
  // A model without materials (formats that hold none, meshes written to them) says nothing about light.
  const bool has_materials = context.scene.materials.size() > 1;
  if (!any && !faces.empty()) out.add({.cluster = kWholeModel, .grave = has_materials});
}

}  // namespace

constinit const Rule no_emitter{
    .id = "RL402",
    .alias = "no-emitter",
    .title = "Nothing in the model emits light",
    .message = "no material in use emits light: a solution of this model would be black",
    .requirement = Requirement::Materials,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .grave_at_solve = scene::Severity::Error,
    .fix = scene::FixClass::Manual,
    .citation = "baum91 1",
    .doc = {.what = "No face has a material that emits light.",
            .why = "Radiosity distributes the light of the emitters. Where there are none, everything is black.",
            .how = "Emission is Ke of an OBJ material and emissiveFactor times strength of a glTF material; lamps that "
                   "are no surfaces (KHR_lights_punctual, lights of a scene file) are not emitters here. A note, and "
                   "at stage solve an error where the model has materials.",
            .fix = "Give the faces that shine a material that emits. Nothing is needed where the model is only to be "
                   "repaired or meshed.",
            .modeller =
                "Blender: Emission of the Principled BSDF; the OBJ and glTF exporters write it. SketchUp, Rhino and "
                "Revit: give lamps a material of their own and add Ke to it in the MTL file.",
            .limits = "Light that comes from a picture of the emission (map_Ke) is not seen: RL405."},
    .check = &check,
};

}  // namespace rad::validate
