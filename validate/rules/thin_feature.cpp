#include <cmath>

#include "validate/rules.h"
#include "validate/thin_features.h"

namespace rad::validate {
namespace {

// What a user is told to type: three digits, never more than what keeps the feature.
double rounded_down(double length) {
  const double step = std::pow(10, std::floor(std::log10(length)) - 2);
  return std::floor(length / step) * step;
}

double kept_below(const Context& context, const ThinFeature& feature) {
  if (feature.kept_pitches() < geom::kRefusedBelowPitches) return 0;
  const double length = rounded_down(context.length(feature.kept_pitches()));
  return length < context.length(geom::kRefusedBelowPitches) ? 0 : length;
}

std::string_view words_for(ThinKind kind) {
  switch (kind) {
    case ThinKind::Plate:
      return "plate thinner than the weld distance";
    case ThinKind::Slit:
      return "slit narrower than the weld distance";
    case ThinKind::Strip:
      return "strip narrower than twice the tolerance";
  }
  return {};
}

void check(const Context& context, Violations& out) {
  for (const ThinFeature& feature : find_thin_features(context)) {
    out.add({.faces = feature.faces,
             .point = context.position(feature.point),
             .measure = context.length(feature.thickness),
             .area = context.area(feature.area),
             .kept_below = kept_below(context, feature),
             .cluster = kPerParticipants + static_cast<std::uint64_t>(feature.kind),
             .detail = words_for(feature.kind)});
  }
}

}  // namespace

constinit const Rule thin_feature{
    .id = "RL107",
    .alias = "thin-feature",
    .title = "A part is too thin for the tolerance",
    .message = "{detail}{object}: {measure} at the thinnest, {area} in {n} place{s}, may close; {advice}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"thickness", MeasureUnit::Length, true},
    .fix = scene::FixClass::None,
    .citation = "baum91 2.1, 3.1",
    .doc =
        {.what = "Two sides of one part, such as a glass pane, a sheet of metal or the slat of a blind, are nearer to "
                 "each other than the weld distance of 1.16 T, or a face is a strip narrower than 2 T.",
         .why = "What comes that near counts as noise and is welded: a solid pane flattens into a sheet of two sides, "
                "a slit closes, a strip closes to a line and is gone. Nothing is wrong with the model, but it is too "
                "fine for the tolerance. So this is asked of every input, whatever the stage, and listed before "
                "anything is welded.",
         .how = "Plates and slits: near-parallel triangles (2.6 degrees) of one part that overlap in a region more "
                "than T/2 wide on average, apart by more than nothing and at most 1.16 T, rounded up to a step of the "
                "scene lattice. A part holds together by edges that are the same on the lattice; open parts also by "
                "what lies within T. Strips: faces of one plane, together narrower than 2 T and longer than 4 T.",
         .fix = "Where the feature matters, run both programs with the --tolerance that the finding names. Where it "
                "does not, let radfix close it: its ledger says what was lost.",
         .modeller =
             "SketchUp, Revit, Rhino, Blender: draw a pane or a sheet as a single face where its thickness is of "
             "no account to the light, and as a solid of real thickness where it is.",
         .limits = "Sides of different closed parts are contacts (RL222) however near they are, and sides that look "
                   "the same way are overlaps (RL220). Sides that coincide on "
                   "the lattice are RL114 or RL222, faces thinner than T are RL007. Slots in a sheet without thickness "
                   "are not looked for. Very dense scenes are searched in part only."},
    .check = &check,
};

}  // namespace rad::validate
