#include <algorithm>
#include <array>

#include "validate/component_members.h"
#include "validate/gaps.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-gap", "T", kGapTolerances, 1, 1000, "distance up to which a sheet counts as laid on a face"},
};

double threshold(const Context& context) {
  return context.parameter(z_offset_decal, "max-gap") * context.tolerance.length;
}

// One for each sheet, at its farthest vertex.
void check(const Context& context, Violations& out) {
  const std::vector<bool> sheets = open_flat_sheets(context);
  if (std::ranges::find(sheets, true) == sheets.end()) return;
  const double reach = context.parameter(z_offset_decal, "max-gap") * static_cast<double>(context.tolerance.pitches);
  const std::vector<ComponentGap> gaps = find_gaps(context, reach, sheets);
  const std::vector<bool> decal = decals_among(context, sheets, gaps);
  std::vector<const ComponentGap*> farthest(decal.size(), nullptr);
  for (const ComponentGap& gap : gaps) {
    const ComponentGap*& kept = farthest[context.topology.component_of_face[gap.vertex_face]];
    if (kept == nullptr || gap.width > kept->width) kept = &gap;
  }
  for (std::size_t id = 0; id < decal.size(); ++id) {
    if (!decal[id]) continue;
    const ComponentGap& gap = *farthest[id];
    const dvec3 from = context.position(gap.vertex), to = context.position(gap.foot);
    out.add({.faces = {gap.vertex_face, gap.face},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(gap.width),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule z_offset_decal{
    .id = "RL223",
    .alias = "z-offset-decal",
    .title = "A sheet floats just above a face",
    .message = "{n} sheet{s} {floats|float} {measure} above a face{object}, as if laid on it",
    .requirement = Requirement::NoOverlappingFaces,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Review,
    .measure = {"distance", MeasureUnit::Length},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 3.3",
    .doc = {.what = "A flat, open sheet lies over a face, parallel to it, nearer than 20 T and farther than T: a "
                    "picture, a marking or a carpet that was moved off the face so as not to flicker.",
            .why = "The sheet shadows the face below, and light creeps in at its rim: a dark or bright seam runs "
                   "around it. What lies below is meshed and solved for nothing.",
            .how = "Every vertex of the sheet is more than T and at most 20 T from another part, whose face there is "
                   "parallel to within 1 degree.",
            .fix = "Put the sheet into the plane of the face: radfix then lets it win over the face (Coplanar).",
            .modeller = "SketchUp: paste the picture onto the face, or Position Texture. Revit: Paint or Split Face. "
                        "Rhino: split the face by its outline. Blender: knife the outline into the face.",
            .limits = "Sheets that hang over an edge of the face, and closed plates, are not reported here (RL212)."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
