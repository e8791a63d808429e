#include <array>
#include <cmath>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

std::vector<bool> used_vertices(const scene::Scene& scene) {
  std::vector<bool> used(scene.vertices.size(), false);
  for (const scene::VertexId corner : scene.corners) used[corner] = true;
  return used;
}

// One violation for all, at the first by place.
void check(const Context& context, Violations& out) {
  const auto& vertices = context.scene.vertices;
  const std::vector<bool> used = used_vertices(context.scene);
  const auto place = [&](scene::VertexId id) { return std::array{vertices[id].x, vertices[id].y, vertices[id].z}; };
  std::uint64_t count = 0;
  scene::VertexId first = kNoVertex;
  for (scene::VertexId id = 0; id < vertices.size(); ++id) {
    const dvec3& p = vertices[id];
    if (used[id] || !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
    ++count;
    if (first == kNoVertex || place(id) < place(first)) first = id;
  }
  if (count == 0) return;
  out.add({.point = vertices[first], .vertex = first, .count = count, .cluster = kWholeModel});
}

}  // namespace

constinit const Rule unused_vertex{
    .id = "RL004",
    .alias = "unused-vertex",
    .title = "Vertices belong to no face",
    .message = "{n} vertex record{s} {belongs|belong} to no face",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "",
    .doc = {.what = "The file holds vertices that no face uses.",
            .why = "They do no harm: they count neither for the size of the model nor for its tolerance. Very many "
                   "mean that faces got lost on the way.",
            .how = "A vertex record that is a corner of no face. Vertices of lines and points count as unused, since "
                   "those are left out (RL010).",
            .fix = "Nothing is required: radfix does not write them.",
            .modeller = "Blender: Mesh > Clean Up > Delete Loose. Rhino: SelPt and delete, or Compact. SketchUp and "
                        "Revit do not write them.",
            .limits = "Vertices whose coordinates are not finite are not counted (RL003)."},
    .check = &check,
};

}  // namespace rad::validate
