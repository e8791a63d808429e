#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "scene/disjoint_sets.h"
#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {
namespace {

constexpr std::array kParameters{
    Parameter{"max-diameter", "T", 2, 1, 100, "largest extent of a cluster of vertices that count as one"},
};

double tolerances(const Context& context) { return context.parameter(merge_chain, "max-diameter"); }

double threshold(const Context& context) { return tolerances(context) * context.tolerance.length; }

struct Member {
  PointId first = 0;  ///< of its cluster
  PointId point = 0;
  FaceId face = 0;

  friend auto operator<=>(const Member&, const Member&) = default;
};

// Per pair of near vertices the first vertex of its cluster: near ones have the same.
std::vector<PointId> clusters_of(const std::vector<NearVertices>& pairs) {
  std::vector<PointId> points;
  for (const NearVertices& near : pairs) points.insert(points.end(), {near.a, near.b});
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto slot = [&](PointId point) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points, point) - points.begin());
  };
  scene::DisjointSets sets(points.size());
  for (const NearVertices& near : pairs) sets.unite(slot(near.a), slot(near.b));
  std::vector<PointId> first;
  for (const NearVertices& near : pairs) first.push_back(points[sets.find(slot(near.a))]);
  return first;
}

// Vertices that are near to others, by cluster.
std::vector<Member> members_of_clusters(const Context& context) {
  std::vector<Member> members;
  const auto& pairs = context.contacts.near_vertices;
  const std::vector<PointId> first = clusters_of(pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    members.push_back({first[i], pairs[i].a, pairs[i].a_face});
    members.push_back({first[i], pairs[i].b, pairs[i].b_face});
  }
  std::sort(members.begin(), members.end(), [&](const Member& x, const Member& y) {
    if (x.first != y.first) return x.first < y.first;
    if (x.point != y.point) return x.point < y.point;
    return x.face != y.face && context.precedes(x.face, y.face);
  });
  const auto again = std::ranges::unique(
      members, [](const Member& x, const Member& y) { return x.first == y.first && x.point == y.point; });
  members.erase(again.begin(), again.end());
  return members;
}

using Cluster = std::span<const Member>;

// Ids follow the lexicographic order of places: the two ends are the first and the last but for chains across x, whose
// box says the same to within a factor of √3. The distance of the ends is exact.
std::array<Member, 2> ends_of(const Context& context, Cluster cluster) {
  std::array<Member, 2> ends{cluster.front(), cluster.front()};
  std::int64_t farthest = 0;
  const auto& points = context.model.points;
  for (const Member& from : {cluster.front(), cluster.back()}) {
    for (const Member& to : cluster) {
      const std::int64_t distance = geom::squared_distance(points[from.point], points[to.point]);
      if (distance > farthest) {
        farthest = distance;
        ends = {from, to};
      }
    }
  }
  return ends;
}

void check(const Context& context, Violations& out) {
  const std::vector<Member> members = members_of_clusters(context);
  const double limit = tolerances(context) * static_cast<double>(context.tolerance.pitches);
  for (std::size_t begin = 0; begin < members.size();) {
    std::size_t end = begin;
    while (end < members.size() && members[end].first == members[begin].first) ++end;
    const auto [a, b] = ends_of(context, Cluster(members).subspan(begin, end - begin));
    begin = end;
    const auto& points = context.model.points;
    const double extent = std::sqrt(static_cast<double>(geom::squared_distance(points[a.point], points[b.point])));
    if (extent <= limit) continue;
    const dvec3 from = context.position(a.point), to = context.position(b.point);
    out.add({.faces = {a.face, b.face},
             .point = (from + to) * 0.5,
             .segment = std::array{from, to},
             .measure = context.length(extent),
             .cluster = kPerParticipants});
  }
}

}  // namespace

constinit const Rule merge_chain{
    .id = "RL122",
    .alias = "merge-chain",
    .title = "A chain of near vertices is longer than the tolerance allows",
    .message =
        "{n} chain{s} of vertices, each within the tolerance of the next{object}: {measure} from end to end "
        "(at most {limit})",
    .requirement = Requirement::Input,
    .severity = scene::Severity::Warning,
    .kind = scene::FindingKind::Review,
    .measure = {"extent of the chain", MeasureUnit::Length},
    .fix = scene::FixClass::Manual,
    .citation = "baum91 3.1",
    .doc = {.what = "Vertices lie so that each is within T of the next, and the first and the last are more than 2 T "
                    "apart.",
            .why = "Which of them are the same vertex is not a question of the tolerance any more: merged as a whole "
                   "they move a surface by more than T, and merged in part the result hangs on where one starts.",
            .how = "Vertices of faces that come within T of each other are joined; a set that is wider than 2 T is a "
                   "chain. Its two ends are named.",
            .fix = "Make T smaller with --tolerance where the detail matters, or weld the vertices in the modeller. "
                   "radfix keeps vertices that are more than 1.16 T apart and moves none by more than 4 T.",
            .modeller = "Blender: Merge by Distance. Rhino: Weld or Reduce on the mesh. SketchUp and Revit: raise the "
                        "scale of the model or lower the number of segments of small circles.",
            .limits = "The extent is that between the farthest from the two outermost along x: for long chains across "
                      "x it may be a little less than the largest."},
    .parameters = kParameters,
    .check = &check,
    .threshold = &threshold,
};

}  // namespace rad::validate
