// DXF entities that are one record each: 3DFACE, SOLID, TRACE, LINE, CIRCLE, ARC, LWPOLYLINE.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "readers/curve_division.h"
#include "readers/dxf_outline.h"
#include "readers/dxf_surfaces.h"

namespace rad::readers::dxf {
namespace {

constexpr dvec3 kUp{0, 0, 1};
constexpr double kDegree = std::numbers::pi / 180;
constexpr std::int64_t kClosed = 1;

void use_object_frame(const Entity& entity, Surfaces& surfaces) {
  surfaces.use_frame(object_frame(entity.point(210, kUp)));
}

void count_curve(const Entity& entity, Surfaces& surfaces) {
  surfaces.count_unsupported(std::string(entity.type()) + " entities without thickness (curves)", entity.line());
}

// A triangle repeats its third corner, or states three.
void add_3dface(const Entity& entity, Surfaces& surfaces) {
  std::array<dvec3, 4> points;
  const std::size_t stated = entity.find(13) != nullptr ? 4 : 3;
  for (std::size_t i = 0; i < stated; ++i) points[i] = entity.point(10 + static_cast<int>(i));
  const std::size_t count = stated == 4 && points[3] == points[2] ? 3 : stated;
  std::array<scene::VertexId, 4> corners{};
  for (std::size_t i = 0; i < count; ++i) corners[i] = surfaces.add_vertex(points[i], entity.line());
  surfaces.add_face(std::span(corners.data(), count), entity.line());
}

// The third and the fourth corner of SOLID and TRACE are stated crosswise.
void add_solid(const Entity& entity, Surfaces& surfaces) {
  use_object_frame(entity, surfaces);
  std::vector<OutlinePoint> outline;
  for (const int code : {10, 11, 13, 12}) {
    if (code == 13 && (entity.find(13) == nullptr || entity.point(13) == entity.point(12))) continue;
    outline.push_back({entity.point(code), 0, entity.line()});
  }
  add_plate(outline, entity.number(39), surfaces);
}

void add_line(const Entity& entity, Surfaces& surfaces) {
  const double thickness = entity.number(39);
  if (!has_thickness(thickness)) return count_curve(entity, surfaces);
  // Both ends are in the world's frame; only the direction of the thickness is not.
  const dvec3 rise = dvec3(object_frame(entity.point(210, kUp))[2]) * thickness;
  const dvec3 from = entity.point(10), to = entity.point(11);
  std::array<scene::VertexId, 4> corners{};
  const std::array<dvec3, 4> points = {from, to, to + rise, from + rise};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = surfaces.add_vertex(points[i], entity.line());
  surfaces.add_face(corners, entity.line());
}

std::vector<OutlinePoint> arc_points(const Entity& entity, double from, double angle, std::uint32_t points,
                                     std::uint32_t chords) {
  const dvec3 centre = entity.point(10);
  const double radius = entity.number(40);
  std::vector<OutlinePoint> outline;
  for (std::uint32_t i = 0; i < points; ++i) {
    const double turn = from + angle * i / chords;
    outline.push_back({centre + radius * dvec3(std::cos(turn), std::sin(turn), 0), 0, entity.line()});
  }
  return outline;
}

// With a thickness a circle is a cylinder with both ends.
void add_circle(const Entity& entity, Surfaces& surfaces) {
  const double thickness = entity.number(39);
  if (!has_thickness(thickness)) return count_curve(entity, surfaces);
  use_object_frame(entity, surfaces);
  add_plate(arc_points(entity, 0, 2 * std::numbers::pi, kChordsOfCircle, kChordsOfCircle), thickness, surfaces);
}

void add_arc(const Entity& entity, Surfaces& surfaces) {
  const double thickness = entity.number(39);
  if (!has_thickness(thickness)) return count_curve(entity, surfaces);
  use_object_frame(entity, surfaces);
  const double from = entity.number(50) * kDegree;
  double angle = std::fmod(entity.number(51) * kDegree - from, 2 * std::numbers::pi);
  if (angle <= 0) angle += 2 * std::numbers::pi;
  const std::uint32_t chords = chords_of_arc(angle);
  add_walls(arc_points(entity, from, angle, chords + 1, chords), false, thickness, surfaces);
}

// Every code 10 begins a corner; 20 and 42 belong to the corner begun last.
std::vector<OutlinePoint> corners_of(const Entity& entity) {
  std::vector<OutlinePoint> outline;
  const double elevation = entity.number(38);
  for (const Group& group : entity.groups()) {
    if (group.code == 10) outline.push_back({{entity.number_of(group), 0, elevation}, 0, group.line});
    if (outline.empty()) continue;
    if (group.code == 20) outline.back().at.y = entity.number_of(group);
    if (group.code == 42) outline.back().bulge = entity.number_of(group);
  }
  return outline;
}

void add_lwpolyline(const Entity& entity, Surfaces& surfaces) {
  const double thickness = entity.number(39);
  if (!has_thickness(thickness)) return count_curve(entity, surfaces);
  if (entity.number(43) > 0) surfaces.count_unsupported("widths of polylines", entity.line());
  use_object_frame(entity, surfaces);
  const bool closed = (entity.integer(70) & kClosed) != 0;
  add_walls(divided(corners_of(entity), closed), closed, thickness, surfaces);
}

struct Handler {
  std::string_view type;
  void (*add)(const Entity&, Surfaces&);
};

constexpr std::array<Handler, 7> kHandlers = {{{"3DFACE", add_3dface},
                                               {"SOLID", add_solid},
                                               {"TRACE", add_solid},
                                               {"LINE", add_line},
                                               {"CIRCLE", add_circle},
                                               {"ARC", add_arc},
                                               {"LWPOLYLINE", add_lwpolyline}}};

}  // namespace

bool add_simple_entity(const Entity& entity, Surfaces& surfaces) {
  for (const Handler& handler : kHandlers) {
    if (handler.type != entity.type()) continue;
    handler.add(entity, surfaces);
    return true;
  }
  return false;
}

}  // namespace rad::readers::dxf
