#include "geom/planar_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace rad::geom {
namespace {

double distance(const PlanePoint& a, const PlanePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double triangle_shape(std::span<const PlanePoint> p) {
  const double a = distance(p[1], p[2]), b = distance(p[2], p[0]), c = distance(p[0], p[1]);
  const double doubled = std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x));
  // 2 r/R with r = 2A/(a+b+c) and R = abc/4A.
  return 4 * doubled * doubled / ((a + b + c) * a * b * c);
}

struct Line {  // inside where n·p + d >= 0, |n| = 1
  double nx, ny, d;
  [[nodiscard]] double height(const PlanePoint& p) const { return nx * p.x + ny * p.y + d; }
};

std::vector<Line> edge_lines(std::span<const PlanePoint> p) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const PlanePoint& a = p[i];
    const PlanePoint& b = p[(i + 1) % p.size()];
    const double length = distance(a, b);
    const double nx = -(b.y - a.y) / length, ny = (b.x - a.x) / length;
    lines.push_back({nx, ny, -(nx * a.x + ny * a.y)});
  }
  return lines;
}

// The largest circle in a convex quadrilateral touches three of its edges.
double inscribed_radius(std::span<const PlanePoint> p) {
  const auto lines = edge_lines(p);
  double best = 0;
  for (std::size_t skipped = 0; skipped < 4; ++skipped) {
    const Line &a = lines[(skipped + 1) % 4], &b = lines[(skipped + 2) % 4], &c = lines[(skipped + 3) % 4];
    // Equal heights over a, b and c: two linear equations.
    const double m00 = a.nx - b.nx, m01 = a.ny - b.ny, m10 = b.nx - c.nx, m11 = b.ny - c.ny;
    const double determinant = m00 * m11 - m01 * m10;
    if (determinant == 0) continue;
    const double r0 = b.d - a.d, r1 = c.d - b.d;
    const PlanePoint centre{(r0 * m11 - m01 * r1) / determinant, (m00 * r1 - r0 * m10) / determinant};
    double radius = a.height(centre);
    for (const Line& line : lines) radius = std::min(radius, line.height(centre));
    best = std::max(best, radius);
  }
  return best;
}

// The smallest circle around four points rests on two or three of them.
double enclosing_radius(std::span<const PlanePoint> p) {
  double best = std::numeric_limits<double>::infinity();
  const auto consider = [&](const PlanePoint& centre, double radius) {
    const bool holds = std::all_of(p.begin(), p.end(),
                                   [&](const PlanePoint& q) { return distance(centre, q) <= radius * (1 + 1e-12); });
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
        const PlanePoint offset{(cy * b2 - by * c2) / d, (bx * c2 - cx * b2) / d};
        consider({p[i].x + offset.x, p[i].y + offset.y}, std::hypot(offset.x, offset.y));
      }
    }
  }
  return best;
}

}  // namespace

double scaled_shape(std::span<const PlanePoint> corners) {
  if (corners.size() == 3) return triangle_shape(corners);
  return std::numbers::sqrt2 * inscribed_radius(corners) / enclosing_radius(corners);
}

}  // namespace rad::geom
