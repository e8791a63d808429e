// Things that stand on others or stick through them.
#include <array>
#include <cmath>
#include <numbers>

#include "corpus/hard/kinds.h"

namespace rad::corpus {
namespace {

/// Sheets that stand on, in or just over a floor; some have a back.
void walls(HardSketch& s) {
  const std::size_t first = s.drawn();
  s.add(rectangle(0, 0, 1, 1, 0), 0);
  for (int count = s.parts(1, 6); count > 0; --count) {
    const double foot = s.random().one_in(6) ? -0.3 : s.random().one_of({0, 0, 0.5, -0.8, 1.3}) * s.tolerance();
    const double top = s.random().one_in(3) ? 0.5 : foot + s.random().one_of({2 * s.tolerance(), 0.05, 0.4});
    const double x0 = s.random().real(-0.2, 1.2), y0 = s.random().real(-0.2, 1.2);
    const double x1 = s.random().real(-0.2, 1.2), y1 = s.random().real(-0.2, 1.2);
    const Corners wall{{x0, y0, foot}, {x1, y1, foot}, {x1, y1, top}, {x0, y0, top}};
    s.add(wall, s.random().between(1, 3));
    if (s.random().one_in(2)) s.add(reversed(wall), 1);
  }
  s.maybe_turn(first);
}

/// Walls with thickness that stand on a floor, meet in corners and T-junctions, and just miss or overlap.
void thick_walls(HardSketch& s) {
  const std::size_t first = s.drawn();
  s.box({-0.1, -0.1, -0.05}, {1.1, 1.1, 0}, 0);
  for (int count = s.parts(2, 5); count > 0; --count) {
    const double foot = s.noise(s.random().one_of({0, 0, 0.5, 1.5})), width = s.random().one_of({0.03, 0.05});
    const double at = 0.25 * s.random().between(0, 4) + s.noise(s.random().one_of({0, 0.6}));
    const double from = 0.25 * s.random().between(0, 2) + s.noise(s.random().one_of({0, 0.6}));
    const double to = from + 0.25 * s.random().between(1, 2) + s.noise(s.random().one_of({0, 0.6}));
    if (s.random().one_in(2)) {
      s.box({at, from, foot}, {at + width, to, 0.3}, 1);
    } else {
      s.box({from, at, foot}, {to, at + width, 0.3}, 2);
    }
  }
  s.turn_somehow(first);
}

/// Boxes stuck through a slab, upright or not.
void pierced_slab(HardSketch& s) {
  const std::size_t first = s.drawn();
  s.box({0, 0, -0.1}, {1, 1, 0}, 0);
  for (int count = s.parts(1, 4); count > 0; --count) {
    const std::size_t own = s.drawn();
    s.box({-0.15, -0.1, -0.12}, {0.15, 0.1, 0.3}, s.random().between(1, 3));
    const glm::dmat3 turn = s.random().one_in(2) ? s.rotation() : about_z(s.random().real(0, 2 * std::numbers::pi));
    dvec3 by = s.anywhere(1);
    by.z = s.random().one_of({0, 0.12, -0.05, 0.12 + 0.5 * s.tolerance(), 0.12 - 0.9 * s.tolerance()});
    s.transform(own, turn, by);
  }
  s.maybe_turn(first);
}

/// Tubes of many sides through a slab.
void cylinders(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(1, 3); count > 0; --count) {
    const std::size_t own = s.drawn();
    const int sides = s.random().between(5, 24);
    const double radius = s.random().real(0.05, 0.4);
    const double x = s.random().real(-0.3, 0.3), y = s.random().real(-0.3, 0.3);
    s.tube({x, y, 0}, radius, 0.4, sides, 1);
    s.maybe_turn(own);
  }
  s.box({-0.5, -0.5, -0.05}, {0.5, 0.5, s.random().one_of({0, 0.05})}, 0);
  s.maybe_turn(first);
}

/// Two curved walls of unlike facets that touch along a line, or run into each other like tangents.
void curved_walls(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double radius = s.random().one_of({0.2, 0.5});
  const int sides = s.parts(12, 40);
  s.tube({0, 0, 0}, radius, 0.2, sides, 0);
  const double gap = s.noise(s.random().one_of({0, 0.5, 2}));
  if (s.random().one_in(2)) {
    s.tube({2 * radius + gap, 0, 0}, radius, 0.2, s.random().between(12, 40), 1);
  } else {
    const double inner = radius * s.random().one_of({0.5, 0.8});
    s.tube({radius - inner + gap, 0, 0}, inner, 0.2, s.random().between(8, 30), 1);
  }
  s.add({{-1, -radius + gap, -0.1}, {1, -radius + gap, -0.1}, {1, -radius + gap, 0.1}, {-1, -radius + gap, 0.1}}, 2);
  if (s.random().one_in(2)) s.box({-0.6, -0.6, -0.25}, {1.2, 0.6, -0.2 + gap}, 2);
  s.maybe_turn(first);
}

/// A floor of tiles as a whole slightly tilted, tiles of unlike rows not corner to corner, with boxes on it.
void tilted_tiles(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int rows = s.parts(2, 5), columns = s.random().between(2, 6);
  const double share = s.random().one_of({0, 0, 0.2, 0.6});
  for (int j = 0; j < rows; ++j) {
    const double start = s.random().one_of({0, 0.1, 0.05});
    for (int i = 0; i < columns; ++i) {
      Corners tile = rectangle(start + 0.2 * i, 0.2 * j, start + 0.2 * (i + 1), 0.2 * (j + 1), 0);
      for (dvec3& p : tile) p += s.noise_vector(share);
      s.add(tile, (i + j) % 2);
    }
  }
  for (int count = s.random().between(0, 3); count > 0; --count) {
    const dvec3 at = s.anywhere(0.8);
    s.box({at.x, at.y, s.noise(s.random().one_of({0, 0.8}))}, {at.x + 0.15, at.y + 0.1, 0.3}, 2);
  }
  const double slope = s.random().one_of({1e-6, 1e-4, 1e-2, 0.3});
  s.transform(first, {{1, 0, slope}, {0, 1, 0.7 * slope}, {0, 0, 1}}, {0, 0, 0});
  s.maybe_turn(first);
}

}  // namespace

std::span<const HardKind> standing_kinds() {
  static constexpr std::array<HardKind, 6> kKinds{{
      {"walls", walls},
      {"thick_walls", thick_walls},
      {"pierced_slab", pierced_slab},
      {"cylinders", cylinders},
      {"curved_walls", curved_walls},
      {"tilted_tiles", tilted_tiles},
  }};
  return kKinds;
}

}  // namespace rad::corpus
