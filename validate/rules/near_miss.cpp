#include <array>

#include "validate/gaps.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-gap", "T", kGapTolerances, 1, 1000, "gap up to which a contact is taken to be meant"},
};

double threshold(const Context& context) { return context.parameter(near_miss, "max-gap") * context.tolerance.length; }

void check(const Context& context, Violations& out) {
  const std::size_t components = context.topology.components.size();
  const std::vector<ComponentGap> gaps =
      find_gaps(context, context.parameter(near_miss, "max-gap") * static_cast<double>(context.tolerance.pitches),
                std::vector<bool>(components, true));
  const std::vector<bool> decal = decals_among(context, open_flat_sheets(context), gaps);
  const auto component_of = [&](FaceId face) { return context.topology.component_of_face[face]; };
  for (const ComponentGap& gap : gaps_of_edges(context, gaps)) {
    if (decal[component_of(gap.vertex_face)] || decal[component_of(gap.face)]) continue;  // RL223
    const dvec3 from = context.position(gap.vertex), to = context.position(gap.foot);
    out.add({.faces = {gap.vertex_face, gap.face},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(gap.width),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule near_miss{
    .id = "RL212",
    .alias = "near-miss",
    .title = "Parts stop just short of each other",
    .message =
        "{n} vertex point{s} of one part {stops|stop} short of another{object} by {measure}, as if they were "
        "meant to touch",
    .requirement = Requirement::NoImplicitIntersections,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"gap", MeasureUnit::Length, true},
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "snap-gap",
    .citation = "baum91 2.2",
    .doc = {.what = "A vertex of one part is near to another part, within 20 T, and farther than T, so that the two do "
                    "not touch.",
            .why = "Light leaks through such a gap, and the shadow that should begin at the contact begins beside it. "
                   "At the tolerance they are apart, so no repair joins them.",
            .how = "The distance from each vertex of a connected part to the nearest place of any other part: more "
                   "than T and at most 20 T, at both ends of an edge that is longer than that. A vertex that touches "
                   "something already is not asked. The narrowest gap is named. Flat sheets that float over a face "
                   "are RL223.",
            .fix = "Move the parts together, or leave a gap that is meant. A larger --tolerance closes all of them.",
            .modeller = "SketchUp: Move with inference to the endpoint. Revit: Align or Join. Rhino: Snap to End, or "
                        "Align. Blender: vertex snapping, or Merge by Distance for what is one part.",
            .limits = "Edges that pass each other without a vertex near are not found. Tiles and boards with a joint "
                      "between them are reported where the joint is narrow."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
