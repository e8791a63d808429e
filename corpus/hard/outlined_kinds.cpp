// Faces of hard outlines: holes, reflex corners, corners off the plane.
#include <array>
#include <cmath>
#include <numbers>

#include "corpus/hard/kinds.h"

namespace rad::corpus {
namespace {

Corners star(double x, double y, double outer, double inner, int tips, double start) {
  Corners corners;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = start + i * std::numbers::pi / tips, reach = i % 2 == 0 ? outer : inner;
    corners.emplace_back(x + reach * std::cos(angle), y + reach * std::sin(angle), 0);
  }
  return corners;
}

/// Walls with windows, some of which reach to within about T of the edge, and things that stand in them.
void holed_faces(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(1, 3); count > 0; --count) {
    const std::size_t own = s.drawn();
    std::vector<Corners> holes;
    const int windows = s.random().between(1, 3);
    for (int i = 0; i < windows; ++i) {
      const double x = 0.33 * i + s.random().one_of({0.05, 0.02, 1.3 * s.tolerance()});
      const double y = s.random().one_of({0.1, 0.3, 1.5 * s.tolerance()});
      Corners hole = s.random().one_in(3)
                         ? star(x + 0.12, y + 0.2, 0.1, s.random().real(0.02, 0.08), 5, s.random().unit())
                         : rectangle(x, y, x + s.random().real(0.05, 0.25), y + 0.4, 0);
      holes.push_back(reversed(hole));
    }
    s.add_with_holes(rectangle(0, 0, 1, 0.9, 0), holes, s.material());
    if (s.random().one_in(2)) s.box({0.1, 0.15, s.noise(2)}, {0.2, 0.3, 0.1}, 1);
    if (s.random().one_in(2)) s.add(rectangle(0, 0.2, 0.7, 0.5, s.noise(s.random().one_of({0, 1.5}))), 2);
    s.turn_somehow(own);
  }
  s.maybe_turn(first);
}

/// Stars and Ls that lie on and cut each other.
void reflex_faces(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(2, 5); count > 0; --count) {
    const std::size_t own = s.drawn();
    if (s.random().one_in(2)) {
      const double inner = s.random().one_of({0.2, 0.35, 2 * s.tolerance()});
      s.add(star(0, 0, s.random().real(0.4, 0.6), inner, s.random().between(3, 8), s.random().unit()), s.material());
    } else {
      const double w = s.random().one_of({0.3, 0.1, 1.5 * s.tolerance()});
      s.add({{0, 0, 0}, {1, 0, 0}, {1, w, 0}, {w, w, 0}, {w, 1, 0}, {0, 1, 0}}, s.material());
    }
    if (s.random().one_in(2)) {
      s.transform(own, s.rotation(), 0.3 * s.anywhere(1));
    } else {
      const dvec3 by = 0.3 * s.anywhere(1);
      s.transform(own, about_z(s.random().one_of({0, 0.5, 1})), {by.x, by.y, s.noise(s.random().one_of({0, 0.8, 2}))});
    }
  }
  s.maybe_turn(first);
}

/// Polygons whose corners are off their plane by shares of T to many T.
void warped_faces(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double share = s.random().one_of({0.3, 0.9, 1.5, 4, 10});
  for (int count = s.parts(2, 5); count > 0; --count) {
    Corners corners;
    const int sides = s.random().between(4, 8);
    const double radius = s.random().real(0.2, 0.5);
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), s.noise(share));
    }
    const std::size_t own = s.drawn();
    s.add(corners, s.material());
    const dvec3 by = 0.5 * s.anywhere(1);
    s.transform(own, s.random().one_in(2) ? s.rotation() : glm::dmat3(1), {by.x, by.y, 0.2 * by.z});
  }
  s.maybe_turn(first);
}

/// Hills of quads, not flat, in two layers that pass through each other.
void crossing_terrains(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int n = s.parts(3, 5);
  for (int layer = 0; layer < 2; ++layer) {
    std::vector<double> height;
    const double relief = s.random().one_of({0.05, 0.2, 2 * s.tolerance()});
    for (int i = 0; i < (n + 1) * (n + 1); ++i) height.push_back(s.random().real(-relief, relief));
    const auto at = [&](int i, int j) {
      return dvec3(i, j, n * height[static_cast<std::size_t>(i * (n + 1) + j)]) / static_cast<double>(n);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) s.add_maybe_cut({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, layer);
    }
  }
  s.maybe_turn(first);
}

}  // namespace

std::span<const HardKind> outlined_kinds() {
  static constexpr std::array<HardKind, 4> kKinds{{
      {"holed_faces", holed_faces},
      {"reflex_faces", reflex_faces},
      {"warped_faces", warped_faces},
      {"crossing_terrains", crossing_terrains},
  }};
  return kKinds;
}

}  // namespace rad::corpus
