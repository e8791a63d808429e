// Things that lie on each other, exactly or off by about T.
#include <array>
#include <cmath>
#include <numbers>

#include "corpus/hard/kinds.h"

namespace rad::corpus {
namespace {

/// Boxes between points of one coarse grid, so that sides coincide; some are off it by a share of T.
void grid_boxes(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double step = s.random().one_of({5 * s.tolerance(), 0.2, 1.0});
  const int grid = s.random().between(3, 6);
  for (int count = s.parts(2, 7); count > 0; --count) {
    const double share = s.random().one_of({0, 0, 0, 0.3, 0.7, 1.1});
    dvec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const int from = s.random().between(0, grid - 1), to = from + s.random().between(1, 3);
      low[axis] = from * step + s.noise(share);
      high[axis] = to * step + s.noise(share);
    }
    s.box(low, high, s.material());
  }
  s.turn_somehow(first);
}

/// Rectangles that overlap in one plane or within 2 T of it.
void sheets(HardSketch& s) {
  const std::size_t first = s.drawn();
  for (int count = s.parts(2, 7); count > 0; --count) {
    const double extent = s.random().one_of({0.1, 1.0});
    dvec3 corner = s.anywhere(extent);
    corner.z = s.noise(s.random().one_of({0, 0, 1, 2}));
    const double angle = s.random().one_of({0, 0, 1}) * s.random().real(0, 2 * std::numbers::pi);
    const dvec3 u(std::cos(angle), std::sin(angle), 0), v(-u.y, u.x, 0);
    const double width = s.random().real(0.03, extent), height = s.random().real(0.03, extent);
    s.add_either_way({corner, corner + width * u, corner + width * u + height * v, corner + height * v});
  }
  s.maybe_turn(first);
}

/// Stacks of sheets at distances about T, some with an underside.
void slabs(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int count = s.parts(2, 8);
  for (int i = 0; i < count; ++i) {
    const double z = i * s.random().one_of({0.9, 0.9, 1.1, 0.5}) * s.tolerance();
    const double x = s.random().one_of({0, 0.2}) * s.random().unit(),
                 y = s.random().one_of({0, 0.2}) * s.random().unit();
    const double w = s.random().one_in(2) ? 1 : s.random().real(0.2, 1);
    const double h = s.random().one_in(2) ? 1 : s.random().real(0.2, 1);
    s.add(rectangle(x, y, x + w, y + h, z), s.material());
    if (s.random().one_in(2)) {
      s.add(reversed(rectangle(x, y, x + w, y + h, z - 0.45 * s.tolerance())), s.material());
    }
  }
  s.maybe_turn(first);
}

/// Stairs of closed steps whose faces touch, each off its neighbour by a millionth, by a share of T or by about T.
void stairs(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double tread = s.random().one_of({0.05, 0.2}), rise = s.random().one_of({0.05, 0.17});
  const double offset = s.random().one_of({0, 1e-6, 1e-6, 0.3 * s.tolerance(), 0.9 * s.tolerance()});
  const int count = s.parts(3, 8);
  for (int i = 0; i < count; ++i) {
    const double x = i * tread + s.random().real(-1, 1) * offset, slip = s.random().real(-1, 1) * offset;
    const double bottom = s.random().one_in(3) ? 0 : i * rise;
    s.box({x, slip, bottom}, {(i + 1) * tread, 1 + slip, (i + 1) * rise + slip}, i % 2);
  }
  s.turn_somehow(first);
}

/// Boxes and the same boxes once more, moved by about T.
void shifted_copies(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double step = s.random().one_of({0.1, 0.3, 1});
  for (int count = s.parts(1, 3); count > 0; --count) {
    dvec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = s.random().between(0, 2) * step;
      high[axis] = low[axis] + s.random().between(1, 2) * step;
    }
    s.box(low, high, s.random().between(0, 1));
  }
  s.maybe_turn(first);
  s.copy(first, s.random().one_of({0.3, 0.7, 1.0, 1.5, 3}) * s.tolerance() * s.direction());
}

/// A storey: outer walls with thickness, partitions, a floor and a ceiling, a doorway with a lintel.
void storey(HardSketch& s, double z, double wall) {
  const double height = 0.3;
  s.box({0, 0, z - wall}, {1, 0.8, z}, 0);
  s.box({0, 0, z}, {1, wall, z + height}, 1);
  s.box({0, 0.8 - wall, z}, {1, 0.8, z + height}, 1);
  s.box({0, wall, z}, {wall, 0.8 - wall, z + height}, 1);
  s.box({1 - wall, wall, z}, {1, 0.8 - wall, z + height}, 1);
  const double x = s.random().real(0.3, 0.6);
  s.box({x, wall, z}, {x + wall, 0.3, z + height}, 2);
  s.box({x, 0.45, z}, {x + wall, 0.8 - wall, z + height}, 2);
  s.box({x, 0.3, z + 0.2}, {x + wall, 0.45, z + height}, 2);
}

/// A building of slabs and walls that touch, superposed by itself within a share of T to some T.
void superposed_buildings(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double wall = s.random().one_of({0.03, 0.06});
  for (int level = 0; level < s.size(); ++level) storey(s, level * (0.3 + wall), wall);
  s.turn_somehow(first);
  const dvec3 along = s.random().one_in(3) ? s.direction() : dvec3(1, 0, 0);
  s.copy(first, s.random().one_of({0.3, 0.3, 0.8, 1.2, 3}) * s.tolerance() * along);
}

/// One surface tessellated twice, in unlike ways, within T of each other.
void two_tessellations(HardSketch& s) {
  const std::size_t first = s.drawn();
  const double bend = s.random().one_of({0, 0, 0.5, 2, 0.2 / s.tolerance()});
  for (int layer = 0; layer < 2; ++layer) {
    const int nx = s.parts(2, 5), ny = s.random().between(2, 5);
    const double lift = s.noise(s.random().one_of({0, 0.3, 1.2}));
    const auto at = [&](int i, int j) {
      const double x = static_cast<double>(i) / nx, y = static_cast<double>(j) / ny;
      return dvec3(x, y, lift + bend * s.tolerance() * x * (1 - x));
    };
    const bool backwards = s.random().one_in(4);
    for (int i = 0; i < nx; ++i) {
      for (int j = 0; j < ny; ++j) {
        const Corners cell{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        s.add_maybe_cut(backwards ? reversed(cell) : cell, layer);
      }
    }
  }
  s.maybe_turn(first);
}

/// Faces that are there already, once more: whole, in two pieces, or turned over, some off by a share of T.
void doubled_faces(HardSketch& s) {
  const std::size_t first = s.drawn();
  grid_boxes(s);
  const std::size_t last = s.drawn();
  for (int count = s.parts(2, 6); count > 0; --count) {
    SketchFace face = s.faces()[first + s.random().index(last - first)];
    const dvec3 by = s.noise_vector(s.random().one_of({0, 0, 0.4, 1.1}));
    for (dvec3& p : face.outer) p += by;
    if (s.random().one_in(2)) face.outer = reversed(face.outer);
    face.material = s.material();
    s.faces().push_back(std::move(face));
  }
}

/// Panels side by side with gaps and laps of about T between them, and steps of about T from one to the next.
void near_joints(HardSketch& s) {
  const std::size_t first = s.drawn();
  const int rows = s.parts(2, 4), columns = s.random().between(2, 5);
  const double share = s.random().one_of({0.3, 0.9, 1.3, 2, 4});
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      Corners panel = rectangle(0.2 * i, 0.2 * j, 0.2 * (i + 1), 0.2 * (j + 1), 0);
      const bool flat = s.random().one_in(2);
      for (dvec3& p : panel) {
        const dvec3 by = s.noise_vector(share);
        p += flat ? dvec3(by.x, by.y, 0) : by;
      }
      s.add_maybe_cut(panel, s.random().between(0, 1));
    }
  }
  s.maybe_turn(first);
}

}  // namespace

std::span<const HardKind> coincident_kinds() {
  static constexpr std::array<HardKind, 9> kKinds{{
      {"grid_boxes", grid_boxes},
      {"sheets", sheets},
      {"slabs", slabs},
      {"stairs", stairs},
      {"shifted_copies", shifted_copies},
      {"superposed_buildings", superposed_buildings},
      {"two_tessellations", two_tessellations},
      {"doubled_faces", doubled_faces},
      {"near_joints", near_joints},
  }};
  return kKinds;
}

}  // namespace rad::corpus
