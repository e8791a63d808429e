#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

struct ShortEdge {
  std::array<PointId, 2> edge{};  ///< ascending
  FaceId face = 0;
  std::int64_t squared_length = 0;
};

// Exact: 25 times the length against 29 T.
bool is_short(std::int64_t squared_length, std::int64_t tolerance) {
  static_assert(geom::kWeldRatio == 1.16);
  return 625 * squared_length <= 841 * tolerance * tolerance;
}

// One for each edge, with the first face that has it.
std::vector<ShortEdge> short_edges(const Context& context) {
  std::vector<ShortEdge> edges;
  for (FaceId face = 0; face < context.scene.faces.size(); ++face) {
    if (context.model.left_out[face]) continue;
    for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) {
      const auto corners = context.model.corners_of(loop);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId a = corners[i], b = corners[(i + 1) % corners.size()];
        const std::int64_t squared = geom::squared_distance(context.model.points[a], context.model.points[b]);
        if (a == b || !is_short(squared, context.tolerance.pitches)) continue;
        edges.push_back({{std::min(a, b), std::max(a, b)}, face, squared});
      }
    }
  }
  std::sort(edges.begin(), edges.end(), [&](const ShortEdge& x, const ShortEdge& y) {
    if (x.edge != y.edge) return x.edge < y.edge;
    return x.face != y.face && context.precedes(x.face, y.face);
  });
  const auto again = std::ranges::unique(edges, {}, &ShortEdge::edge);
  edges.erase(again.begin(), again.end());
  return edges;
}

// One violation for all edges of an object and material, at the shortest.
void check(const Context& context, Violations& out) {
  std::map<std::pair<scene::ObjectId, scene::MaterialId>, std::pair<ShortEdge, std::uint64_t>> shortest;
  for (const ShortEdge& edge : short_edges(context)) {
    const auto owner = std::pair(context.object_of(edge.face), context.material_of(edge.face));
    auto& [kept, count] = shortest.try_emplace(owner, edge, 0).first->second;
    if (edge.squared_length < kept.squared_length) kept = edge;
    ++count;
  }
  for (const auto& [owner, entry] : shortest) {
    const auto& [edge, count] = entry;
    const dvec3 a = context.position(edge.edge[0]), b = context.position(edge.edge[1]);
    out.add({.faces = {edge.face, kNoFace},
             .point = (a + b) * 0.5,
             .segment = std::array{a, b},
             .measure = context.length(std::sqrt(static_cast<double>(edge.squared_length))),
             .count = count,
             .cluster = kPerParticipants});
  }
}

double threshold(const Context& context) { return geom::kWeldRatio * context.tolerance.length; }

}  // namespace

constinit const Rule short_edge{
    .id = "RL108",
    .alias = "short-edge",
    .title = "Edges are shorter than the weld distance",
    .message =
        "{n} edge{s}{object} no longer than {limit}, the weld distance, will collapse; the shortest is "
        "{measure}",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Note,
    .kind = scene::FindingKind::Informational,
    .measure = {"length", MeasureUnit::Length, true},
    .fix = scene::FixClass::None,
    .citation = "baum91 3.1",
    .doc = {.what = "Edges of faces have ends that are nearer to each other than the weld distance of 1.16 T.",
            .why = "The Grouper welds their ends, so detail of that size is lost. A few such edges are noise of the "
                   "modeller; very many mean that T is too large for the model.",
            .how = "The length is at most 1.16 T, exactly, on the scene lattice; edges that have become points there "
                   "are not counted. One finding for each object and material, at its shortest edge.",
            .fix = "Nothing is required. Make T smaller with --tolerance where the detail matters.",
            .modeller = "Blender: Merge by Distance shows how many vertices fall together. Rhino: raise the density of "
                        "the render mesh no further than the detail asks. SketchUp: fewer segments for small circles. "
                        "Revit: a coarser level of detail.",
            .limits = "The rims of thin plates (RL107) are counted too."},
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
