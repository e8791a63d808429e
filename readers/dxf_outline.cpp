#include "readers/dxf_outline.h"

#include <algorithm>
#include <cmath>

#include "readers/curve_division.h"

namespace rad::readers::dxf {
namespace {

using scene::VertexId;

// Points of the arc after its first one, up to and without its last one.
void append_arc(const OutlinePoint& from, const dvec3& to, std::vector<OutlinePoint>& points) {
  const double angle = 4 * std::atan(from.bulge);
  const dvec3 chord = to - from.at;
  if (!std::isfinite(angle) || (chord.x == 0 && chord.y == 0)) return;
  // From the middle of the chord to the centre: half a chord times cot(angle / 2), to the left.
  const double reach = (1 - from.bulge * from.bulge) / (4 * from.bulge);
  const dvec3 centre = (from.at + to) * 0.5 + dvec3(-chord.y, chord.x, 0) * reach;
  const std::uint32_t count = chords_of_arc(angle);
  for (std::uint32_t i = 1; i < count; ++i) {
    const double turn = angle * i / count;
    const dvec3 arm = from.at - centre;
    const dvec3 turned(arm.x * std::cos(turn) - arm.y * std::sin(turn), arm.x * std::sin(turn) + arm.y * std::cos(turn),
                       arm.z);
    points.push_back({centre + turned, 0, from.line});
  }
}

std::vector<VertexId> add_ring(const std::vector<OutlinePoint>& outline, double height, Surfaces& surfaces) {
  std::vector<VertexId> ring;
  ring.reserve(outline.size());
  for (const OutlinePoint& point : outline) {
    ring.push_back(surfaces.add_vertex(point.at + dvec3(0, 0, height), point.line));
  }
  return ring;
}

void add_walls_between(const std::vector<VertexId>& low, const std::vector<VertexId>& high,
                       const std::vector<OutlinePoint>& outline, bool closed, Surfaces& surfaces) {
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i + 1 < count || (closed && i < count); ++i) {
    const std::size_t next = (i + 1) % count;
    surfaces.add_face({low[i], low[next], high[next], high[i]}, outline[i].line);
  }
}

// Walls look to the right of the outline where they go up, to the left where they go down.
void add_walls_upwards(const std::vector<OutlinePoint>& outline, bool closed, double thickness, Surfaces& surfaces) {
  const auto low = add_ring(outline, std::min(thickness, 0.0), surfaces);
  const auto high = add_ring(outline, std::max(thickness, 0.0), surfaces);
  add_walls_between(low, high, outline, closed, surfaces);
}

double signed_area(const std::vector<OutlinePoint>& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const dvec3 a = outline[i].at - outline[0].at, b = outline[(i + 1) % outline.size()].at - outline[0].at;
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace

bool has_thickness(double thickness) { return std::abs(thickness) > 0; }

std::vector<OutlinePoint> divided(const std::vector<OutlinePoint>& outline, bool closed) {
  std::vector<OutlinePoint> points;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    points.push_back(outline[i]);
    const bool last = i + 1 == outline.size();
    if (outline[i].bulge == 0 || (last && !closed)) continue;
    append_arc(outline[i], outline[last ? 0 : i + 1].at, points);
  }
  return points;
}

void add_walls(const std::vector<OutlinePoint>& outline, bool closed, double thickness, Surfaces& surfaces) {
  if (outline.size() >= 2) add_walls_upwards(outline, closed && outline.size() > 2, thickness, surfaces);
}

void add_plate(const std::vector<OutlinePoint>& outline, double thickness, Surfaces& surfaces) {
  if (outline.size() < 3) return;
  if (!has_thickness(thickness)) {
    surfaces.add_face(add_ring(outline, 0, surfaces), outline.front().line);
    return;
  }
  std::vector<OutlinePoint> ring = outline;
  // Anticlockwise, so that the walls look outwards.
  if (signed_area(ring) < 0) std::ranges::reverse(ring);
  auto low = add_ring(ring, std::min(thickness, 0.0), surfaces);
  const auto high = add_ring(ring, std::max(thickness, 0.0), surfaces);
  add_walls_between(low, high, ring, true, surfaces);
  surfaces.add_face(high, ring.front().line);
  std::ranges::reverse(low);
  surfaces.add_face(low, ring.front().line);
}

}  // namespace rad::readers::dxf
