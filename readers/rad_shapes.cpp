#include "readers/rad_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "readers/curve_division.h"

namespace rad::readers::radiance {
namespace {

using geom::dvec3;
using Ring = std::vector<std::uint32_t>;

constexpr std::uint32_t kAround = kChordsOfCircle;
constexpr std::uint32_t kBetweenPoles = kChordsOfCircle / 2;

// Two unit vectors across a unit axis, right-handed with it.
std::array<dvec3, 2> across(const dvec3& axis) {
  // Away from the axis: along the coordinate in which it is smallest.
  const dvec3 size = glm::abs(axis);
  const dvec3 away = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                     : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                          : dvec3(0, 0, 1);
  const dvec3 u = glm::normalize(glm::cross(away, axis));
  return {u, glm::cross(axis, u)};
}

Ring add_circle(Shape& shape, const dvec3& centre, const std::array<dvec3, 2>& sides, double radius) {
  Ring ring;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAround;
    ring.push_back(static_cast<std::uint32_t>(shape.points.size()));
    shape.points.push_back(centre + radius * (std::cos(angle) * sides[0] + std::sin(angle) * sides[1]));
  }
  return ring;
}

std::uint32_t add_point(Shape& shape, const dvec3& point) {
  shape.points.push_back(point);
  return static_cast<std::uint32_t>(shape.points.size() - 1);
}

// Faces between two circles, or a circle and a tip, that look outwards where `high` lies along the axis.
void add_band(Shape& shape, const Ring& low, const Ring& high) {
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t j = (i + 1) % kAround;
    if (low.size() == 1) {
      shape.faces.push_back({low[0], high[j], high[i]});
    } else if (high.size() == 1) {
      shape.faces.push_back({low[i], low[j], high[0]});
    } else {
      shape.faces.push_back({low[i], low[j], high[j], high[i]});
    }
  }
}

void turn_over(Shape& shape) {
  for (Ring& ring : shape.faces) std::ranges::reverse(ring);
}

dvec3 point_at(std::span<const double> reals, std::size_t first) {
  return {reals[first], reals[first + 1], reals[first + 2]};
}

Shape fail(std::string& problem, std::string why) {
  problem = std::move(why);
  return {};
}

Shape polygon(std::span<const double> reals, std::string& problem) {
  if (reals.size() < 9 || reals.size() % 3 != 0) {
    return fail(problem, "a polygon of " + std::to_string(reals.size()) + " numbers is no list of points");
  }
  Shape shape;
  Ring ring;
  for (std::size_t i = 0; i < reals.size(); i += 3) ring.push_back(add_point(shape, point_at(reals, i)));
  // The last point may repeat the first.
  if (shape.points.front() == shape.points.back() && ring.size() > 3) ring.pop_back();
  shape.faces.push_back(std::move(ring));
  return shape;
}

Shape sphere(std::span<const double> reals, bool inwards, std::string& problem) {
  if (reals.size() != 4) return fail(problem, "a sphere takes four numbers");
  const dvec3 centre = point_at(reals, 0);
  const double radius = reals[3];
  if (radius == 0) return fail(problem, "a sphere has the radius 0");
  Shape shape;
  const dvec3 up(0, 0, 1);
  Ring below{add_point(shape, centre - std::abs(radius) * up)};
  for (std::uint32_t i = 1; i <= kBetweenPoles; ++i) {
    const double angle = std::numbers::pi * i / kBetweenPoles;
    const dvec3 level = centre - std::abs(radius) * std::cos(angle) * up;
    Ring ring = i == kBetweenPoles
                    ? Ring{add_point(shape, centre + std::abs(radius) * up)}
                    : add_circle(shape, level, {dvec3(1, 0, 0), dvec3(0, 1, 0)}, std::abs(radius) * std::sin(angle));
    add_band(shape, below, ring);
    below = std::move(ring);
  }
  // A negative radius turns a sphere inside out.
  if (inwards != (radius < 0)) turn_over(shape);
  return shape;
}

// From (centre, centre, radius, radius).
Shape cone(const dvec3& from, const dvec3& to, double r0, double r1, bool inwards, std::string& problem) {
  const double height = glm::length(to - from);
  if (height == 0) return fail(problem, "a cone or cylinder has no height; a flat one is a ring");
  if (r0 < 0 || r1 < 0 || (r0 == 0 && r1 == 0)) return fail(problem, "a cone or cylinder has no positive radius");
  const auto sides = across((to - from) / height);
  Shape shape;
  const Ring low = r0 == 0 ? Ring{add_point(shape, from)} : add_circle(shape, from, sides, r0);
  const Ring high = r1 == 0 ? Ring{add_point(shape, to)} : add_circle(shape, to, sides, r1);
  add_band(shape, low, high);
  if (inwards) turn_over(shape);
  return shape;
}

Shape cone_of(std::span<const double> reals, bool inwards, std::string& problem) {
  if (reals.size() != 8) return fail(problem, "a cone takes eight numbers");
  return cone(point_at(reals, 0), point_at(reals, 3), reals[6], reals[7], inwards, problem);
}

Shape cylinder_of(std::span<const double> reals, bool inwards, std::string& problem) {
  if (reals.size() != 7) return fail(problem, "a cylinder takes seven numbers");
  return cone(point_at(reals, 0), point_at(reals, 3), reals[6], reals[6], inwards, problem);
}

Shape ring_of(std::span<const double> reals, std::string& problem) {
  if (reals.size() != 8) return fail(problem, "a ring takes eight numbers");
  const dvec3 centre = point_at(reals, 0), normal = point_at(reals, 3);
  const double inner = std::min(reals[6], reals[7]), outer = std::max(reals[6], reals[7]);
  const double length = glm::length(normal);
  if (length == 0 || !(inner >= 0) || !(outer > inner)) return fail(problem, "a ring has no area or no normal");
  const auto sides = across(normal / length);
  Shape shape;
  shape.faces.push_back(add_circle(shape, centre, sides, outer));
  if (inner == 0) return shape;
  shape.holes.push_back(add_circle(shape, centre, sides, inner));
  std::ranges::reverse(shape.holes.front());
  return shape;
}

constexpr std::array<std::string_view, 8> kSurfaces = {"polygon", "sphere",   "bubble", "cone",
                                                       "cup",     "cylinder", "tube",   "ring"};

}  // namespace

bool is_surface(std::string_view type) { return std::ranges::find(kSurfaces, type) != kSurfaces.end(); }

Shape shape_of(std::string_view type, std::span<const double> reals, std::string& problem) {
  if (type == "polygon") return polygon(reals, problem);
  if (type == "sphere" || type == "bubble") return sphere(reals, type == "bubble", problem);
  if (type == "cone" || type == "cup") return cone_of(reals, type == "cup", problem);
  if (type == "cylinder" || type == "tube") return cylinder_of(reals, type == "tube", problem);
  return ring_of(reals, problem);
}

}  // namespace rad::readers::radiance
