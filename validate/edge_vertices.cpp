#include "validate/edge_vertices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace rad::validate {
namespace {

double distance_from_line(const Context& context, const VertexOnEdge& event) {
  const dvec3 from = geom::as_vector(context.model.points[event.edge[0]]);
  const dvec3 along = geom::as_vector(context.model.points[event.edge[1]]) - from;
  const dvec3 offset = geom::as_vector(context.model.points[event.vertex]) - from;
  return glm::length(glm::cross(along, offset)) / glm::length(along);
}

bool one_surface(const Context& context, const VertexOnEdge& event) {
  return context.topology.surface_of_face[event.edge_face] == context.topology.surface_of_face[event.vertex_face];
}

// The pair of faces to name, among all pairs that give the same vertex and edge.
const VertexOnEdge& named_pair(const Context& context, std::span<const VertexOnEdge> events, bool within_surface) {
  const VertexOnEdge* best = nullptr;
  for (const VertexOnEdge& event : events) {
    if (within_surface && !one_surface(context, event)) continue;
    const bool better = best == nullptr || context.precedes(event.edge_face, best->edge_face) ||
                        (event.edge_face == best->edge_face && context.precedes(event.vertex_face, best->vertex_face));
    if (better) best = &event;
  }
  return *best;
}

// Where nothing but faces that lie on each other back to back meets, as between a ceiling and the lamp under it, no
// face is seen, and no pixel can open.
bool out_of_sight(const Context& context, std::span<const VertexOnEdge> events) {
  return std::ranges::all_of(
      events, [&](const VertexOnEdge& event) { return back_to_back(context, event.edge_face, event.vertex_face); });
}

}  // namespace

bool back_to_back(const Context& context, FaceId a, FaceId b) {
  const dvec3 &u = context.triangles.normal[a], &v = context.triangles.normal[b];
  return glm::dot(u, v) <= -geom::kParallelCosine * glm::length(u) * glm::length(v);
}

void report_t_vertices(const Context& context, bool within_surface, Violations& out) {
  const auto& events = context.contacts.vertices_on_edges;
  for (std::size_t begin = 0; begin < events.size();) {
    std::size_t end = begin;
    bool inside = false;
    for (; end < events.size() && events[end].edge == events[begin].edge && events[end].vertex == events[begin].vertex;
         ++end) {
      inside = inside || one_surface(context, events[end]);
    }
    const auto group = std::span(events).subspan(begin, end - begin);
    if (inside == within_surface && !out_of_sight(context, group)) {
      const VertexOnEdge& event = named_pair(context, group, within_surface);
      out.add({.faces = {event.edge_face, event.vertex_face},
               .point = context.position(event.vertex),
               .segment = std::array{context.position(event.edge[0]), context.position(event.edge[1])},
               .measure = context.length(distance_from_line(context, event))});
    }
    begin = end;
  }
}

}  // namespace rad::validate
