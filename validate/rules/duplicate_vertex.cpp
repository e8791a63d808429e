#include <algorithm>
#include <array>
#include <cmath>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

using Position = std::array<double, 3>;

void check(const Context& context, Violations& out) {
  if (context.scene.splits_vertices) return;  // the format cannot share vertices: repeating them is no fault
  std::vector<Position> positions;
  for (const dvec3& p : context.scene.vertices) {
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) positions.push_back({p.x, p.y, p.z});
  }
  std::sort(positions.begin(), positions.end());
  std::uint64_t repeats = 0;
  const Position* first = nullptr;
  for (std::size_t i = 1; i < positions.size(); ++i) {
    if (positions[i] != positions[i - 1]) continue;
    ++repeats;
    if (first == nullptr) first = &positions[i];
  }
  if (first == nullptr) return;
  out.add({.point = dvec3((*first)[0], (*first)[1], (*first)[2]), .count = repeats, .cluster = kPerParticipants});
}

}  // namespace

constinit const Rule duplicate_vertex{
    .id = "RL005",
    .alias = "duplicate-vertex",
    .title = "Vertices repeat the position of another",
    .message = "{n} vertex record{s} {repeats|repeat} the position of another",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .fix = scene::FixClass::Safe,
    .fix_operation = "grouper",
    .citation = "baum91 3.1",
    .doc = {.what = "Two or more vertex records have exactly the same coordinates.",
            .why =
                "Faces that meet there do not share the vertex, so connectivity has to be rebuilt by position before "
                "the solution can be interpolated over the surface.",
            .how =
                "Coordinates are compared bit for bit, before any tolerance. Formats that cannot share vertices (STL, "
                "glTF attribute seams) are exempt. Connectivity rules here count equal positions as one vertex.",
            .fix = "Nothing is required: radfix welds them (Grouper).",
            .modeller = "Blender: Merge by Distance. Rhino: Weld. SketchUp and Revit write vertices anew for each "
                        "face: nothing to do.",
            .limits = "Vertices that no face uses are counted too."},
    .check = &check,
};

}  // namespace rad::validate
