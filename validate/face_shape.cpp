#include "validate/face_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "validate/rings.h"

namespace rad::validate {
namespace {

struct Point2 {
  double x = 0;
  double y = 0;
};

double distance(const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// The corners of the outer loop in an orthonormal frame of the face's plane, in pitches; from the smallest on, so that
// rounding does not depend on the corner that the file starts with.
std::vector<Point2> flattened(const Context& context, FaceId face) {
  const auto corners = context.model.corners_of(context.scene.loops[context.scene.faces[face].first_loop]);
  std::vector<PointId> ring(corners.begin(), corners.end());
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  const auto vector_of = [&](PointId id) {
    const geom::LatticePoint& p = context.model.points[id];
    return dvec3(p.x, p.y, p.z);
  };
  const dvec3 origin = vector_of(ring[0]);
  const dvec3 u = glm::normalize(vector_of(ring[1]) - origin);
  const dvec3 v = glm::cross(glm::normalize(context.triangles.normal[face]), u);
  std::vector<Point2> points;
  for (const PointId p : ring) {
    const dvec3 offset = vector_of(p) - origin;
    points.push_back({glm::dot(offset, u), glm::dot(offset, v)});
  }
  return points;
}

double triangle_shape(const std::vector<Point2>& p) {
  const double a = distance(p[1], p[2]), b = distance(p[2], p[0]), c = distance(p[0], p[1]);
  const double doubled = std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x));
  // 2 r/R with r = 2A/(a+b+c) and R = abc/4A.
  return 4 * doubled * doubled / ((a + b + c) * a * b * c);
}

struct Line {  // inside where n·p + d >= 0, |n| = 1
  double nx, ny, d;
  [[nodiscard]] double height(const Point2& p) const { return nx * p.x + ny * p.y + d; }
};

std::vector<Line> edge_lines(const std::vector<Point2>& p) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2& a = p[i];
    const Point2& b = p[(i + 1) % p.size()];
    const double length = distance(a, b);
    const double nx = -(b.y - a.y) / length, ny = (b.x - a.x) / length;
    lines.push_back({nx, ny, -(nx * a.x + ny * a.y)});
  }
  return lines;
}

// The largest circle in a convex quadrilateral touches three of its edges.
double inscribed_radius(const std::vector<Point2>& p) {
  const auto lines = edge_lines(p);
  double best = 0;
  for (std::size_t skipped = 0; skipped < 4; ++skipped) {
    const Line &a = lines[(skipped + 1) % 4], &b = lines[(skipped + 2) % 4], &c = lines[(skipped + 3) % 4];
    // Equal heights over a, b and c: two linear equations.
    const double m00 = a.nx - b.nx, m01 = a.ny - b.ny, m10 = b.nx - c.nx, m11 = b.ny - c.ny;
    const double determinant = m00 * m11 - m01 * m10;
    if (determinant == 0) continue;
    const double r0 = b.d - a.d, r1 = c.d - b.d;
    const Point2 centre{(r0 * m11 - m01 * r1) / determinant, (m00 * r1 - r0 * m10) / determinant};
    double radius = a.height(centre);
    for (const Line& line : lines) radius = std::min(radius, line.height(centre));
    best = std::max(best, radius);
  }
  return best;
}

// The smallest circle around four points rests on two or three of them.
double enclosing_radius(const std::vector<Point2>& p) {
  double best = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Point2& centre, double radius) {
    const bool holds =
        std::all_of(p.begin(), p.end(), [&](const Point2& q) { return distance(centre, q) <= radius * (1 + 1e-12); });
    if (holds) best = std::min(best, radius);
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      consider({(p[i].x + p[j].x) / 2, (p[i].y + p[j].y) / 2}, distance(p[i], p[j]) / 2);
      for (std::size_t k = j + 1; k < p.size(); ++k) {
        const double bx = p[j].x - p[i].x, by = p[j].y - p[i].y, cx = p[k].x - p[i].x, cy = p[k].y - p[i].y;
        const double d = 2 * (bx * cy - by * cx);
        if (d == 0) continue;
        const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
        const Point2 offset{(cy * b2 - by * c2) / d, (bx * c2 - cx * b2) / d};
        consider({p[i].x + offset.x, p[i].y + offset.y}, std::hypot(offset.x, offset.y));
      }
    }
  }
  return best;
}

}  // namespace

std::uint64_t corner_count(const Context& context, FaceId face) {
  std::uint64_t count = 0;
  for (const scene::Loop& loop : context.scene.loops_of(context.scene.faces[face])) count += loop.count;
  return count;
}

bool is_triangle_or_convex_quad(const Context& context, FaceId face) {
  const scene::Face& record = context.scene.faces[face];
  const scene::Loop& loop = context.scene.loops[record.first_loop];
  if (record.loop_count != 1 || loop.count > 4) return false;
  if (loop.count == 3) return true;
  const dvec3& n = context.triangles.normal[face];
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const int dropped = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  std::vector<geom::PlanarPoint> points;
  for (const PointId p : context.model.corners_of(loop))
    points.push_back(geom::project(context.model.points[p], dropped));
  return is_convex(points, Ring{0, 1, 2, 3}, true);
}

double scaled_shape(const Context& context, FaceId face) {
  const std::vector<Point2> points = flattened(context, face);
  if (points.size() == 3) return triangle_shape(points);
  return std::numbers::sqrt2 * inscribed_radius(points) / enclosing_radius(points);
}

}  // namespace rad::validate
