#include "validate/edge_vertices.h"

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

}  // namespace

void report_t_vertices(const Context& context, bool within_surface, Violations& out) {
  const auto& events = context.contacts.vertices_on_edges;
  for (std::size_t begin = 0; begin < events.size();) {
    std::size_t end = begin;
    bool inside = false;
    for (; end < events.size() && events[end].edge == events[begin].edge && events[end].vertex == events[begin].vertex;
         ++end) {
      inside = inside || one_surface(context, events[end]);
    }
    if (inside == within_surface) {
      const VertexOnEdge& event = named_pair(context, std::span(events).subspan(begin, end - begin), within_surface);
      out.add({.faces = {event.edge_face, event.vertex_face},
               .point = context.position(event.vertex),
               .segment = std::array{context.position(event.edge[0]), context.position(event.edge[1])},
               .measure = context.length(distance_from_line(context, event))});
    }
    begin = end;
  }
}

}  // namespace rad::validate
