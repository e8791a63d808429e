// Much of the same in one place.
#include <array>

#include "corpus/hard/kinds.h"

namespace rad::corpus {
namespace {

/// Triangles anywhere.
void soup(HardSketch& s) {
  const double extent = s.random().one_of({10 * s.tolerance(), 0.2, 0.4, 1, 1});
  for (int count = s.parts(10, 50); count > 0; --count) {
    const dvec3 centre = s.anywhere(extent);
    const double share = s.random().one_of({0.05, 0.2, 0.5}) * extent / s.tolerance();
    const dvec3 a = centre + s.noise_vector(share), b = centre + s.noise_vector(share);
    s.add({a, b, centre + s.noise_vector(share)}, s.material());
  }
}

/// Triangles between the points of a small grid: everything meets everything, exactly.
void grid_soup(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int grid = s.random().between(2, 4);
  const double step = s.random().one_of({4 * s.tolerance(), 0.25});
  const auto point = [&] {
    const double x = s.random().between(0, grid), y = s.random().between(0, grid);
    return step * dvec3(x, y, s.random().between(0, grid));
  };
  for (int count = s.parts(5, 20); count > 0; --count) {
    const dvec3 a = point(), b = point();
    s.add({a, b, point()}, s.material());
  }
  s.turn_somehow(first);
}

/// Cubes of a grid that touch face to face, each closed, some missing, some off by a share of T.
void cube_grid(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int n = s.random().between(2, 3) * s.size();
  const double step = s.random().one_of({5 * s.tolerance(), 0.2}), share = s.random().one_of({0, 0, 0.3, 0.9});
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < 2; ++z) {
        if (s.random().one_in(4)) continue;
        const dvec3 low = step * dvec3(x, y, z) + s.noise_vector(share);
        s.box(low, step * dvec3(x + 1, y + 1, z + 1) + s.noise_vector(share), (x + y + z) % 2);
      }
    }
  }
  s.turn_somehow(first);
}

void menger_part(HardSketch& s, const dvec3& low, double extent, int level) {
  if (level == 0) return s.box(low, low + dvec3(extent), 0);
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 3; ++z) {
        const bool open = (x == 1) + (y == 1) + (z == 1) >= 2;
        if (!open) menger_part(s, low + extent / 3 * dvec3(x, y, z), extent / 3, level - 1);
      }
    }
  }
}

/// A Menger sponge of closed cubes, all of which touch others; with something pushed through it.
void menger_sponge(HardSketch& s) {
  const std::size_t first = s.drawn();
  menger_part(s, {0, 0, 0}, 1, s.size());
  if (s.random().one_in(2)) {
    const dvec3 low = 0.5 * s.anywhere(1);
    s.box(low, low + dvec3(0.4, 0.3, 0.6), 1);
  }
  s.turn_somehow(first);
}

}  // namespace

std::span<const HardKind> crowded_kinds() {
  static constexpr std::array<HardKind, 4> kKinds{{
      {"soup", soup},
      {"grid_soup", grid_soup},
      {"cube_grid", cube_grid},
      {"menger_sponge", menger_sponge},
  }};
  return kKinds;
}

}  // namespace rad::corpus
