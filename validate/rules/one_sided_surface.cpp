#include <algorithm>

#include "validate/context.h"
#include "validate/neighbours.h"
#include "validate/orientation_sets.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

bool any_disagreement(const Context& context) {
  bool any = false;
  for (const Subedge& subedge : context.topology.subedges) {
    for_each_neighbours(context, subedge, [&](const Coedge& a, const Coedge& b) { any |= a.forward == b.forward; });
  }
  return any;
}

void check(const Context& context, Violations& out) {
  if (!any_disagreement(context)) return;
  for (const std::vector<FaceId>& faces : find_orientation_sets(context).one_sided) {
    const FaceId first = *std::min_element(faces.begin(), faces.end(),
                                           [&](FaceId a, FaceId b) { return context.precedes(a, b); });
    out.add({.faces = {first, kNoFace},
             .point = context.centre(first),
             .measure = static_cast<double>(faces.size()),
             .cluster = context.topology.component_of_face[first] + std::uint64_t{1}});
  }
}

}  // namespace

constinit const Rule one_sided_surface{
    .id = "RL115",
    .alias = "one-sided-surface",
    .title = "A surface has one side only",
    .message = "no turning makes {measure} connected faces agree{object}: the surface has one side only",
    .requirement = Requirement::NormalConsistency,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"faces", MeasureUnit::Count},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 2.1",
    .doc = {.what = "Connected faces cannot be turned so that all neighbours look the same way, as on a Möbius strip.",
            .why = "Somewhere the front of a face continues as the back of the next: one of them is black from there.",
            .how = "Neighbours (RL110) are joined with the parity of their agreement; a way around that ends with the "
                   "other parity makes the set one-sided.",
            .fix = "Cut the surface open or double it (radfix --two-sided). Often one face too many closes it wrongly.",
            .modeller = "Blender: Select > All by Trait > Non Manifold shows where parts are joined that should not "
                        "be. Rhino: Dir shows where directions change. SketchUp and Revit have no tool for it.",
            .limits = "Edges at which more than two faces of an object meet are not crossed, so a surface that is "
                      "one-sided only across them is not found."},
    .check = &check,
};

}  // namespace rad::validate
