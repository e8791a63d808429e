// Things about as thin as T.
#include <array>
#include <cmath>
#include <numbers>

#include "corpus/hard/kinds.h"

namespace rad::corpus {
namespace {

/// Triangles about as thick as T.
void needles(HardSketch& s) {
  for (int count = s.parts(3, 25); count > 0; --count) {
    const dvec3 a = s.anywhere(1), b = s.anywhere(1);
    const dvec3 near = s.random().one_in(2) ? a : 0.5 * (a + b);
    s.add({a, b, near + s.noise_vector(s.random().one_of({0.3, 0.9, 1.1, 1.5, 3}))}, s.random().between(0, 1));
  }
}

/// A row of thin teeth on a bar.
void comb(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int teeth = s.parts(5, 30);
  const double pitch = s.random().one_of({1.17, 1.3, 2, 3}) * s.tolerance();
  const double width = pitch * s.random().one_of({0.5, 0.9, 1});
  for (int i = 0; i < teeth; ++i) {
    const double x = i * pitch, tip = s.random().one_of({0.1, 0.3, 1.2 * s.tolerance()});
    const double bend = s.noise(s.random().one_of({0, 0, 1}));
    s.add({{x, 0, 0}, {x + width, 0, 0}, {x + width / 2, tip, bend}}, 0);
  }
  const double length = teeth * pitch;
  const double right = s.random().one_of({0, 0.5, -0.5, 2}) * s.tolerance();
  const double left = s.random().one_of({0, 0.5}) * s.tolerance();
  s.add({{-0.01, -0.1, 0},
         {length, -0.1, 0},
         {length, right, 0},
         {-0.01, left, s.random().one_of({0, 0.5}) * s.tolerance()}},
        1);
  if (s.random().one_in(2)) {
    const double lean = s.random().real(-0.02, 0.02);
    s.add({{0, 0.02, -0.1}, {length, 0.02, -0.1}, {length, 0.02 + lean, 0.1}, {0, 0.02, 0.1}}, 2);
  }
  s.maybe_turn(first);
}

/// Triangles around one point, some as narrow as T over most of their length.
void fans(HardSketch& s) {
  for (int count = s.parts(1, 3); count > 0; --count) {
    const std::size_t first = s.drawn();
    const int blades = s.random().between(6, 40);
    const double lift = s.random().one_of({0, 0, 1});
    double angle = 0;
    for (int i = 0; i < blades; ++i) {
      const double next = angle + s.random().one_of({0.5, 2, 5}) * s.tolerance() + s.random().one_of({0, 0.1});
      const double reach = s.random().real(0.3, 0.5), z = s.noise(lift);
      s.add({{0, 0, z},
             reach * dvec3(std::cos(angle), std::sin(angle), 0),
             reach * dvec3(std::cos(next), std::sin(next), 0)},
            i % 2);
      angle = s.random().one_in(3) ? angle : next;
    }
    s.turn_freely(first);
  }
}

/// Plates about as thick as T, through or on each other.
void thin_plates(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(2, 4); count > 0; --count) {
    const std::size_t own = s.drawn();
    const double thickness = s.random().one_of({0.8, 1.2, 1.5, 2.5, 4}) * s.tolerance();
    const double w = s.random().real(0.2, 1), h = s.random().real(0.2, 1);
    s.box({-w / 2, -h / 2, 0}, {w / 2, h / 2, thickness}, s.material());
    const int way = s.random().between(0, 2);
    const dvec3 by = 0.3 * s.anywhere(1);
    if (way == 0) s.transform(own, about_z(s.random().real(0, 3)), {by.x, by.y, s.noise(2)});
    if (way == 1) s.transform(own, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, by);
    if (way == 2) s.transform(own, s.rotation(), by);
  }
  s.maybe_turn(first);
}

/// Rods of a cross section of some T that cross, touch and run along each other.
void rods(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(2, 5); count > 0; --count) {
    const double width = s.random().one_of({1.2, 2, 4}) * s.tolerance();
    const int axis = s.random().between(0, 2);
    dvec3 low(0, 0, 0);
    for (int other = 0; other < 3; ++other) {
      low[other] = s.random().between(-1, 1) * width + s.noise(s.random().one_of({0, 0.6, 1.5}));
    }
    low[axis] = s.random().real(-0.5, 0);
    dvec3 high = low + dvec3(width);
    high[axis] = low[axis] + s.random().real(0.2, 0.8);
    s.box(low, high, s.material());
  }
  s.turn_somehow(first);
}

}  // namespace

std::span<const HardKind> thin_kinds() {
  static constexpr std::array<HardKind, 5> kKinds{{
      {"needles", needles},
      {"comb", comb},
      {"fans", fans},
      {"thin_plates", thin_plates},
      {"rods", rods},
  }};
  return kKinds;
}

}  // namespace rad::corpus
