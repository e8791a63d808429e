#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

std::string_view way_in(const Facade& facade, double tolerance) {
  const double gap = facade.gap ? facade.gap->width / tolerance : kGapReach + 1;
  if (gap <= 2) return "; at the point named its rim leaves a gap of 1 to 2 T";
  if (gap <= 5) return "; at the point named its rim leaves a gap of 2 to 5 T";
  if (gap <= kGapReach) return "; at the point named its rim leaves a gap of 5 to 20 T";
  return facade.from_open_space ? "; it starts in open space, since no material emits light" : "";
}

void check(const Context& context, Violations& out) {
  const Facades& facades = facades_of(context);
  const auto tolerance = static_cast<double>(context.tolerance.pitches);
  for (std::uint32_t id = 0; id < facades.of_component.size(); ++id) {
    const Facade& facade = facades.of_component[id];
    if (facade.verdict != FacadeVerdict::InvalidProved) continue;
    const std::array sight{context.position((*facade.sight)[0]), context.position((*facade.sight)[1])};
    out.add({.faces = {facade.face, kNoFace},
             .point = facade.gap ? context.position(facade.gap->middle) : sight[1],
             .segment = sight,
             .measure = context.area(facade.lit_back_area),
             .cluster = id + std::uint64_t{1},
             .detail = way_in(facade, tolerance)});
  }
}

}  // namespace

constinit const Rule invalid_facade{
    .id = "RL113",
    .alias = "invalid-facade",
    .title = "Light reaches the back of an open surface",
    .message = "its back is seen{object}, {measure} of it from lit space: the line of sight {segment} is free{detail}",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Warning,
    .measure = {"area of the back in lit space", MeasureUnit::Area},
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "two-sided",
    .citation = "baum91 2.1",
    .doc =
        {.what = "The back of an open, single-sided surface can be seen from something that is lit: the surface is an "
                 "invalid facade.",
         .why =
             "A back blocks light and sends none. What lies behind is dark, energy that arrives there is lost, and a "
             "viewer looks through the back at whatever is behind it. The paper calls finding this impractical "
             "before the solution is known.",
         .how = "In a model whose faces meet in whole edges and vertices only, the triangles divide the air into "
                "cells, and light stays in the cells in which it starts: those at the fronts of emitters or, where "
                "nothing emits, open space and rooms. Backs in other cells are never seen, which proves a facade "
                "valid. From backs in lit cells 300 rays look for a line of sight. Its segment is tested in whole "
                "numbers against all triangles, and keeps more than T away from those that do not touch its ends. "
                "docs/facades.md has the proof.",
         .fix = "Close the surface, give it a thickness, or let radfix double it (--two-sided) or close its flat "
                "openings (--cap-planar). `radlint --report leak-line=PATH.obj` writes the lines of sight as a model "
                "to look at.",
         .modeller = "SketchUp: Push/Pull the sheet to a thickness, or close the hole. Blender: Solidify, or Fill. "
                     "Rhino: OffsetSrf with Solid=Yes, or Cap. Revit: export walls with their cores.",
         .limits =
             "Ground is exempt: a surface with nothing behind it, or of one height everywhere that reaches to the "
             "sides of the model. Models in which faces cross or nearly touch have to be repaired first. A back "
             "that sees only other backs is not reported. Cameras of the file are not looked at."},
    .check = &check,
};

}  // namespace rad::validate
