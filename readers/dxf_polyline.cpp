#include "readers/dxf_polyline.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "readers/dxf_outline.h"
#include "readers/refusals.h"

namespace rad::readers::dxf {
namespace {

using scene::VertexId;

// Flags of POLYLINE.
constexpr std::int64_t kClosed = 1, kSpaceCurve = 8, kPolygonMesh = 16, kClosedN = 32, kPolyface = 64;
// Flags of VERTEX.
constexpr std::int64_t kSplineFrame = 16, kMeshVertex = 64, kPolyfaceRecord = 128;

/// Everything between POLYLINE and SEQEND.
struct Vertices {
  std::vector<OutlinePoint> points;
  std::vector<std::array<std::int64_t, 4>> faces;  ///< vertex numbers from 1, 0 for none, negative: edge hidden
  std::vector<std::uint64_t> face_lines;
};

std::array<std::int64_t, 4> face_of(const Entity& vertex) {
  return {vertex.integer(71), vertex.integer(72), vertex.integer(73), vertex.integer(74)};
}

void take(const Entity& vertex, std::int64_t polyline_flags, Vertices& vertices) {
  const std::int64_t flags = vertex.integer(70);
  if ((polyline_flags & kPolyface) != 0 && (flags & kPolyfaceRecord) != 0 && (flags & kMeshVertex) == 0) {
    vertices.faces.push_back(face_of(vertex));
    vertices.face_lines.push_back(vertex.line());
    return;
  }
  // Control points of a curve or surface that has been fitted are not on it.
  if ((flags & kSplineFrame) != 0) return;
  vertices.points.push_back({vertex.point(10), vertex.number(42), vertex.line()});
}

Vertices read_vertices(std::int64_t flags, Groups& groups, scene::ReadIssues& issues) {
  Vertices vertices;
  if (!groups.next()) return vertices;
  Entity vertex(groups, issues);
  while (vertex.type() == "VERTEX") {
    take(vertex, flags, vertices);
    if (!groups.next()) return vertices;
    vertex.read(groups);
  }
  if (vertex.type() == "SEQEND") return vertices;
  issues.add(issue_at_line(scene::ReadIssueKind::ParseError, "a POLYLINE is not closed by SEQEND", vertex.line()));
  return vertices;
}

std::vector<VertexId> add_points(const std::vector<OutlinePoint>& points, Surfaces& surfaces) {
  std::vector<VertexId> ids;
  ids.reserve(points.size());
  for (const OutlinePoint& point : points) ids.push_back(surfaces.add_vertex(point.at, point.line));
  return ids;
}

void add_polyface(const Vertices& vertices, Surfaces& surfaces) {
  const std::vector<VertexId> ids = add_points(vertices.points, surfaces);
  for (std::size_t i = 0; i < vertices.faces.size() && !surfaces.full(); ++i) {
    std::array<VertexId, 4> corners{};
    std::size_t count = 0;
    bool sound = true;
    for (const std::int64_t number : vertices.faces[i]) {
      if (number == 0) continue;
      const auto index = static_cast<std::uint64_t>(std::llabs(number));
      if (index > ids.size()) {
        surfaces.refuse(scene::ReadIssueKind::IndexOutOfRange,
                        index_beyond(static_cast<std::int64_t>(index), ids.size()), vertices.face_lines[i]);
        sound = false;
        break;
      }
      corners[count++] = ids[index - 1];
    }
    if (!sound) continue;
    if (count == 4 && corners[3] == corners[2]) --count;
    if (count >= 3) surfaces.add_face(std::span(corners.data(), count), vertices.face_lines[i]);
    if (count > 0 && count < 3)
      surfaces.count_unsupported("polyface records of fewer than three vertices", vertices.face_lines[i]);
  }
}

// Rows and columns of a fitted mesh are those that it was divided into.
std::array<std::uint64_t, 2> mesh_size(const Entity& head) {
  const auto count = [&](int code) {
    return static_cast<std::uint64_t>(std::clamp<std::int64_t>(head.integer(code), 0, 1 << 20));
  };
  const bool fitted = (head.integer(70) & 4) != 0;
  if (fitted && count(73) > 0 && count(74) > 0) return {count(73), count(74)};
  return {count(71), count(72)};
}

void add_polygon_mesh(const Entity& head, const Vertices& vertices, Surfaces& surfaces) {
  const auto [rows, columns] = mesh_size(head);
  if (rows * columns != vertices.points.size()) {
    return surfaces.refuse(scene::ReadIssueKind::ParseError,
                           "a mesh of " + std::to_string(rows) + " by " + std::to_string(columns) + " has " +
                               std::to_string(vertices.points.size()) + " vertices; it is left out",
                           head.line());
  }
  const std::int64_t flags = head.integer(70);
  const std::vector<VertexId> ids = add_points(vertices.points, surfaces);
  const std::uint64_t last_row = (flags & kClosed) != 0 ? rows : rows - std::min<std::uint64_t>(rows, 1);
  const std::uint64_t last_column = (flags & kClosedN) != 0 ? columns : columns - std::min<std::uint64_t>(columns, 1);
  for (std::uint64_t m = 0; m < last_row && !surfaces.full(); ++m) {
    for (std::uint64_t n = 0; n < last_column; ++n) {
      const std::uint64_t m1 = (m + 1) % rows, n1 = (n + 1) % columns;
      surfaces.add_face({ids[m * columns + n], ids[m1 * columns + n], ids[m1 * columns + n1], ids[m * columns + n1]},
                        vertices.points[m * columns + n].line);
    }
  }
}

void add_outline(const Entity& head, Vertices& vertices, Surfaces& surfaces) {
  const std::int64_t flags = head.integer(70);
  const double thickness = head.number(39);
  if ((flags & kSpaceCurve) != 0 || !has_thickness(thickness)) {
    return surfaces.count_unsupported("POLYLINE entities without thickness (curves)", head.line());
  }
  if (head.number(40) > 0 || head.number(41) > 0) surfaces.count_unsupported("widths of polylines", head.line());
  surfaces.use_frame(object_frame(head.point(210, {0, 0, 1})));
  const double elevation = head.number(30);
  for (OutlinePoint& point : vertices.points) point.at.z = elevation;
  const bool closed = (flags & kClosed) != 0;
  add_walls(divided(vertices.points, closed), closed, thickness, surfaces);
}

}  // namespace

void read_polyline(const Entity& head, Groups& groups, bool visible, Surfaces& surfaces, scene::ReadIssues& issues) {
  const std::int64_t flags = head.integer(70);
  Vertices vertices = read_vertices(flags, groups, issues);
  if (!visible) return;
  if ((flags & kPolyface) != 0) return add_polyface(vertices, surfaces);
  if ((flags & kPolygonMesh) != 0) return add_polygon_mesh(head, vertices, surfaces);
  add_outline(head, vertices, surfaces);
}

}  // namespace rad::readers::dxf
