#include <cmath>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

void check(const Context& context, Violations& out) {
  const auto& vertices = context.scene.vertices;
  for (scene::VertexId id = 0; id < vertices.size(); ++id) {
    const dvec3& p = vertices[id];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    out.add({.vertex = id, .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule non_finite{
    .id = "RL003",
    .alias = "non-finite",
    .title = "A coordinate is not a finite number",
    .message = "{n} vertex position{s} {is|are} not finite (NaN or infinite); faces that use them are left out",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Error,
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "drop-bad-faces",
    .citation = "",
    .doc = {.what = "A vertex has a coordinate that is NaN or infinite.",
            .why = "No area, plane or form factor can be computed from it; one such vertex can spoil a whole solution.",
            .how = "Every coordinate of every vertex is tested. Faces with such a corner take no part in other rules.",
            .fix = "Find the object at the line named and rebuild it; the fault comes from a division by zero in a "
                   "plug-in or exporter.",
            .modeller =
                "Blender: Mesh > Clean Up > Delete Loose, and check modifiers for zero scale. Rhino: SelBadObjects. "
                "SketchUp: check components scaled to zero. Revit: delete and place the element named anew.",
            .limits = "None known."},
    .check = &check,
};

}  // namespace rad::validate
