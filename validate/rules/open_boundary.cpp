#include <map>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

struct Boundary {
  FaceId face = kNoFace;  ///< of the first open stretch
  PointId a = 0, b = 0;
};

// The first open stretch of every component; subedges come in the order of their places.
std::map<std::uint32_t, Boundary> first_openings(const Context& context) {
  std::map<std::uint32_t, Boundary> openings;
  const Topology& topology = context.topology;
  for (const Subedge& subedge : topology.subedges) {
    const auto coedges = topology.coedges_of(subedge);
    if (coedges.size() == 2) continue;
    std::map<std::uint32_t, std::vector<FaceId>> faces;
    for (const Coedge& coedge : coedges) faces[topology.component_of_face[coedge.face]].push_back(coedge.face);
    for (const auto& [component, users] : faces) {
      if (users.size() == 1) openings.emplace(component, Boundary{users[0], subedge.a, subedge.b});
    }
  }
  return openings;
}

std::string_view verdict_text(const Context& context, const Facade& facade) {
  switch (facade.verdict) {
    case FacadeVerdict::ValidProved:
      return facades_of(context).has_emitters ? "valid, proved: no light reaches its back"
                                              : "valid, proved: its back is shut off from open space and from rooms";
    case FacadeVerdict::Terrain:
      return "taken for ground: nothing lies behind it";
    case FacadeVerdict::ProbablyValid:
      return facade.rays == kSightRays ? "probably valid: of 300 rays from its back none found a line of sight to "
                                         "anything lit (with 95 % confidence less than 1 % of what it sees is)"
                                       : "probably valid: of 30 rays from its back none found a line of sight to "
                                         "anything lit (with 95 % confidence less than 10 % of what it sees is)";
    case FacadeVerdict::InvalidProved:
      return "invalid, proved: see RL113";
    case FacadeVerdict::TurnedOver:
      return "turned over: see RL112";
    case FacadeVerdict::Undecided:
    case FacadeVerdict::NotAFacade:
      break;
  }
  return "whether its back is seen is not decided until the model is repaired";
}

void check(const Context& context, Violations& out) {
  for (const auto& [id, opening] : first_openings(context)) {
    const Component& component = context.topology.components[id];
    const dvec3 from = context.position(opening.a), to = context.position(opening.b);
    out.add({.faces = {opening.face, kNoFace},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(component.open_length),
             .count = component.open_subedges,
             .cluster = id + 1,
             .detail = verdict_text(context, facades_of(context).of_component[id])});
  }
}

}  // namespace

constinit const Rule open_boundary{
    .id = "RL101",
    .alias = "open-boundary",
    .title = "An object is not closed: it is a facade",
    .message = "open surface{object}: {n} boundary edge{s}, {measure} long in all; {detail}",
    .requirement = Requirement::SolidModel,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Review,
    .measure = {"boundary length", MeasureUnit::Length},
    .fix = scene::FixClass::Unsafe,
    .fix_operation = "cap-planar",
    .citation = "baum91 2.1",
    .doc =
        {.what = "A connected set of faces has edges that only one face uses.",
         .why = "An open, single-sided surface is a facade. It is valid as long as its back is never seen from lit "
                "space (a box without a bottom that stands on a floor). Where light reaches the back, it passes "
                "through, and the solution is wrong.",
         .how =
             "Edges are matched at the tolerance: vertices within T count as one, and edges with T-vertices as the "
             "chain through them. Faces of different objects that share an edge in pairs count as connected. Whether "
             "the back is in light is proved where the model is conforming, and said (docs/facades.md).",
         .fix = "Close the surface where its back can be seen (radfix --cap-planar closes flat openings), or leave it "
                "where it cannot.",
         .modeller = "SketchUp: Solid Inspector. Rhino: ShowEdges, naked edges. Blender: Select > All by Trait > Non "
                     "Manifold. Revit: facades come from walls exported without their cores.",
         .limits = "Whether the back is seen is not decided in a model that faces cross or nearly touch in."},
    .check = &check,
};

}  // namespace rad::validate
