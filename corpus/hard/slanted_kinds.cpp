// Planes that cut each other at small angles or nearly in one point.
#include <array>
#include <cmath>
#include <numbers>

#include "corpus/hard/kinds.h"

namespace rad::corpus {
namespace {

Corners square(const dvec3& centre, const dvec3& u, const dvec3& v) {
  return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

/// Squares through one another at angles from 1e-6 to 0.1.
void tilted_sheets(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(2, 4); count > 0; --count) {
    const double slope = std::pow(10, s.random().real(-6, -1)), direction = s.random().real(0, 2 * std::numbers::pi);
    const double extent = s.random().one_of({0.2, 1, 3}), start = s.random().real(0, 2 * std::numbers::pi);
    const double x = extent * s.random().real(-0.3, 0.3), y = extent * s.random().real(-0.3, 0.3);
    const dvec3 centre(x, y, s.noise(s.random().one_of({0, 2})));
    Corners corners;
    for (int k = 0; k < 4; ++k) {
      const double angle = start + k * std::numbers::pi / 2;
      dvec3 p = centre + extent * dvec3(std::cos(angle), std::sin(angle), 0);
      p.z += slope * (p.x * std::cos(direction) + p.y * std::sin(direction));
      corners.push_back(p);
    }
    s.add_either_way(corners);
  }
  s.maybe_turn(first);
}

/// Squares in any direction whose planes pass near one point.
void planes_near_a_point(HardSketch& s) {
  glm::dmat3 turn = s.rotation();
  for (int count = s.parts(3, 6); count > 0; --count) {
    if (s.random().one_in(3)) {
      for (int column = 0; column < 3; ++column) turn[column] += s.noise_vector(0.02 / s.tolerance());
    } else {
      turn = s.rotation();
    }
    const dvec3 centre = s.noise_vector(s.random().one_of({0, 1.5}));
    const double extent = s.random().real(0.1, 1);
    s.add(square(centre, extent * turn[0], extent * turn[1]), s.material());
  }
}

/// Squares through one axis, each turned a little further, so that all cut each other in one line.
void coaxial_squares(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int count = s.parts(4, 12);
  const double step = s.random().one_of({std::numbers::pi / count, 0.1});
  for (int i = 0; i < count; ++i) {
    const double angle = i * step + s.random().one_of({0, 0, 1e-4}) * s.random().unit();
    const double extent = s.random().one_of({0.5, 0.5, 0.3});
    const dvec3 axis = s.noise_vector(s.random().one_of({0, 0, 0.5}));
    s.add(square(axis, extent * dvec3(std::cos(angle), std::sin(angle), 0), {0, 0, extent}), i % 3);
  }
  s.maybe_turn(first);
}

/// Squares of one centre in one plane, each turned a little further.
void turned_squares(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int count = s.parts(3, 10);
  const double step = s.random().one_of({std::numbers::pi / 2 / count, 0.1, 0.3});
  for (int i = 0; i < count; ++i) {
    const glm::dmat3 turn = about_z(i * step);
    s.add(square({0, 0, s.noise(s.random().one_of({0, 0, 0.9}))}, 0.5 * turn[0], 0.5 * turn[1]), i % 3);
  }
  s.maybe_turn(first);
}

/// Squares through one axis or of one centre at so small an angle to each other that T is far from where they meet:
/// between neighbours there is nowhere more than about T.
void wedge_stacks(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double step = s.random().one_of({2, 3}) * s.tolerance(), extent = s.random().one_of({0.5, 0.3});
  const bool coaxial = s.random().one_in(2);
  const int count = s.parts(3, 8);
  for (int i = 0; i < count; ++i) {
    const dvec3 along(std::cos(i * step), std::sin(i * step), 0), across(-along.y, along.x, 0);
    s.add(square(s.noise_vector(0.5), extent * along, coaxial ? dvec3(0, 0, extent) : extent * across), i % 3);
  }
  s.maybe_turn(first);
}

/// Roofs: two slopes that meet in a ridge, over others that are a little steeper or moved along.
void near_roofs(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double height = s.random().one_of({0.02, 0.2, 0.5});
  for (int count = s.parts(2, 3); count > 0; --count) {
    const double top = height + s.noise(s.random().one_of({0, 0.5, 2, 5})), x = s.noise(s.random().one_of({0, 1, 3}));
    const double y0 = s.random().one_of({0, 0.3}), y1 = s.random().one_of({1, 0.7});
    s.add_maybe_cut({{-0.5, y0, 0}, {x, y0, top}, {x, y1, top}, {-0.5, y1, 0}}, s.material());
    s.add_maybe_cut({{x, y0, top}, {0.5, y0, 0}, {0.5, y1, 0}, {x, y1, top}}, s.material());
  }
  s.maybe_turn(first);
}

}  // namespace

std::span<const HardKind> slanted_kinds() {
  static constexpr std::array<HardKind, 6> kKinds{{
      {"tilted_sheets", tilted_sheets},
      {"planes_near_a_point", planes_near_a_point},
      {"coaxial_squares", coaxial_squares},
      {"turned_squares", turned_squares},
      {"wedge_stacks", wedge_stacks},
      {"near_roofs", near_roofs},
  }};
  return kKinds;
}

}  // namespace rad::corpus
