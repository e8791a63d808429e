// Small random scenes on which repair is hardest: things that coincide, nearly coincide, or are hardly thicker than T.
#pragma once

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "scene/scene_builder.h"
#include "tests/support/lattice_random.h"

namespace rad::tests {

/// T of these scenes, file units; most of them are about 1 wide.
inline constexpr double kHardTolerance = 0.01;

class HardScene {
 public:
  explicit HardScene(std::uint64_t seed) : random_(seed) {}

  /// Boxes between points of one coarse grid, so that sides coincide; some are off it by a share of T.
  void grid_boxes() {
    const std::size_t first = faces_.size();
    const double step = one_of({0.05, 0.2, 1.0});
    const std::int64_t grid = random_.between(3, 6);
    for (std::int64_t count = random_.between(2, 7); count > 0; --count) {
      const double noise = one_of({0, 0, 0, 0.3, 0.7, 1.1}) * kHardTolerance;
      dvec3 low, high;
      for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t from = random_.between(0, grid - 1);
        low[axis] = static_cast<double>(from) * step + real(-noise, noise);
        high[axis] = static_cast<double>(from + random_.between(1, 3)) * step + real(-noise, noise);
      }
      box(low, high, random_.between(0, 2));
    }
    turn_somehow(first);
  }

  /// Rectangles that overlap in one plane or within 2 T of it.
  void sheets() {
    const std::size_t first = faces_.size();
    for (std::int64_t count = random_.between(2, 7); count > 0; --count) {
      const double size = one_of({0.1, 1.0});
      const dvec3 corner(real(0, size), real(0, size), one_of({0, 0, 1, 2}) * real(-kHardTolerance, kHardTolerance));
      const double angle = one_of({0, 0, 1}) * real(0, 2 * std::numbers::pi);
      const dvec3 u(std::cos(angle), std::sin(angle), 0), v(-u.y, u.x, 0);
      const double width = real(0.03, size), height = real(0.03, size);
      add_either_way({corner, corner + width * u, corner + width * u + height * v, corner + height * v});
    }
    turn_freely(first, 2);
  }

  /// Stacks of sheets at distances about T, some with an underside.
  void slabs() {
    const std::size_t first = faces_.size();
    const std::int64_t count = random_.between(2, 8);
    for (std::int64_t i = 0; i < count; ++i) {
      const double z = static_cast<double>(i) * one_of({0.9, 0.9, 1.1, 0.5}) * kHardTolerance;
      const double x = one_of({0, 0.2}) * random_.unit(), y = one_of({0, 0.2}) * random_.unit();
      const double w = random_.one_in(2) ? 1 : real(0.2, 1), h = random_.one_in(2) ? 1 : real(0.2, 1);
      const auto at = [&](double height) { return rectangle(x, y, x + w, y + h, height); };
      add(at(z), random_.between(0, 2));
      if (random_.one_in(2)) add(reversed(at(z - 0.45 * kHardTolerance)), random_.between(0, 2));
    }
    turn_freely(first, 2);
  }

  /// Squares through one another at angles from 1e-6 to 0.1.
  void tilted_sheets() {
    const std::size_t first = faces_.size();
    for (std::int64_t count = random_.between(2, 4); count > 0; --count) {
      const double slope = std::pow(10, real(-6, -1)), direction = real(0, 2 * std::numbers::pi);
      const double size = one_of({0.2, 1, 3}), start = real(0, 2 * std::numbers::pi);
      const double lift = one_of({0, 2}) * real(-kHardTolerance, kHardTolerance);
      const dvec3 centre(size * real(-0.3, 0.3), size * real(-0.3, 0.3), lift);
      Corners corners;
      for (int k = 0; k < 4; ++k) {
        const double angle = start + k * std::numbers::pi / 2;
        dvec3 p = centre + size * dvec3(std::cos(angle), std::sin(angle), 0);
        p.z += slope * (p.x * std::cos(direction) + p.y * std::sin(direction));
        corners.push_back(p);
      }
      add_either_way(corners);
    }
    turn_freely(first, 2);
  }

  /// Boxes and the same boxes once more, moved by about T.
  void shifted_copies() {
    const std::size_t first = faces_.size();
    const double step = one_of({0.1, 0.3, 1});
    for (std::int64_t count = random_.between(1, 3); count > 0; --count) {
      dvec3 low, high;
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = static_cast<double>(random_.between(0, 2)) * step;
        high[axis] = low[axis] + static_cast<double>(random_.between(1, 2)) * step;
      }
      box(low, high, random_.between(0, 1));
    }
    turn_freely(first, 2);
    const dvec3 by = one_of({0.3, 0.7, 1.0, 1.5, 3}) * kHardTolerance * rotation()[0];
    const std::size_t last = faces_.size();
    for (std::size_t i = first; i < last; ++i) {
      Drawn copy = faces_[i];
      for (dvec3& p : copy.corners) p += by;
      faces_.push_back(std::move(copy));
    }
  }

  /// Sheets that stand on, in or just over a floor; some have a back.
  void walls() {
    const std::size_t first = faces_.size();
    add(rectangle(0, 0, 1, 1, 0), 0);
    for (std::int64_t count = random_.between(1, 6); count > 0; --count) {
      const double foot = random_.one_in(6) ? -0.3 : one_of({0, 0, 0.5, -0.8, 1.3}) * kHardTolerance;
      const double top = random_.one_in(3) ? 0.5 : foot + one_of({0.02, 0.05, 0.4});
      const dvec3 p(real(-0.2, 1.2), real(-0.2, 1.2), foot), q(real(-0.2, 1.2), real(-0.2, 1.2), foot);
      const Corners wall{p, q, {q.x, q.y, top}, {p.x, p.y, top}};
      add(wall, random_.between(1, 3));
      if (random_.one_in(2)) add(reversed(wall), 1);
    }
    turn_freely(first, 2);
  }

  /// Boxes stuck through a slab, upright or not.
  void pierced_slab() {
    const std::size_t first = faces_.size();
    box({0, 0, -0.1}, {1, 1, 0}, 0);
    for (std::int64_t count = random_.between(1, 4); count > 0; --count) {
      const std::size_t own = faces_.size();
      box({-0.15, -0.1, -0.12}, {0.15, 0.1, 0.3}, random_.between(1, 3));
      const glm::dmat3 turn = random_.one_in(2) ? rotation() : about_z(real(0, 2 * std::numbers::pi));
      const double depth = one_of({0, 0.12, -0.05, 0.12 + 0.5 * kHardTolerance, 0.12 - 0.9 * kHardTolerance});
      transform(own, turn, {random_.unit(), random_.unit(), depth});
    }
    turn_freely(first, 2);
  }

  /// Triangles about as thick as T.
  void needles() {
    for (std::int64_t count = random_.between(3, 25); count > 0; --count) {
      const dvec3 a = anywhere(1), b = anywhere(1);
      const double thickness = one_of({0.3, 0.9, 1.1, 1.5, 3}) * kHardTolerance;
      const dvec3 near = random_.one_in(2) ? a : 0.5 * (a + b);
      add({a, b, near + dvec3(real(-thickness, thickness), real(-thickness, thickness), real(-thickness, thickness))},
          random_.between(0, 1));
    }
  }

  /// A row of thin teeth on a bar.
  void comb() {
    const std::size_t first = faces_.size();
    const std::int64_t teeth = random_.between(5, 30);
    const double pitch = one_of({1.17, 1.3, 2, 3}) * kHardTolerance, width = pitch * one_of({0.5, 0.9, 1});
    for (std::int64_t i = 0; i < teeth; ++i) {
      const double x = static_cast<double>(i) * pitch;
      const double tip = one_of({0.1, 0.3, 1.2 * kHardTolerance});
      const double bend = one_of({0, 0, 1}) * real(-kHardTolerance, kHardTolerance);
      add({{x, 0, 0}, {x + width, 0, 0}, {x + width / 2, tip, bend}}, 0);
    }
    const double length = static_cast<double>(teeth) * pitch;
    const double right = one_of({0, 0.5, -0.5, 2}) * kHardTolerance, left = one_of({0, 0.5}) * kHardTolerance;
    add({{-0.01, -0.1, 0}, {length, -0.1, 0}, {length, right, 0}, {-0.01, left, one_of({0, 0.5}) * kHardTolerance}}, 1);
    if (random_.one_in(2)) {
      add({{0, 0.02, -0.1}, {length, 0.02, -0.1}, {length, 0.02 + real(-0.02, 0.02), 0.1}, {0, 0.02, 0.1}}, 2);
    }
    turn_freely(first, 2);
  }

  /// Tubes of many sides through a slab.
  void cylinders() {
    const std::size_t first = faces_.size();
    for (std::int64_t count = random_.between(1, 3); count > 0; --count) tube();
    box({-0.5, -0.5, -0.05}, {0.5, 0.5, one_of({0, 0.05})}, 0);
    turn_freely(first, 2);
  }

  /// Squares in any direction whose planes pass near one point.
  void planes_near_a_point() {
    glm::dmat3 turn = rotation();
    for (std::int64_t count = random_.between(3, 6); count > 0; --count) {
      if (random_.one_in(3)) {
        for (int column = 0; column < 3; ++column)
          turn[column] += dvec3(real(-0.02, 0.02), real(-0.02, 0.02), real(-0.02, 0.02));
      } else {
        turn = rotation();
      }
      const dvec3 centre = one_of({0, 1.5}) * kHardTolerance * (2.0 * anywhere(1) - 1.0);
      const double size = real(0.1, 1);
      const dvec3 u = size * turn[0], v = size * turn[1];
      add({centre - u - v, centre + u - v, centre + u + v, centre - u + v}, random_.between(0, 2));
    }
  }

  /// Triangles anywhere.
  void soup() {
    const double size = one_of({0.1, 0.2, 0.4, 1, 1});
    for (std::int64_t count = random_.between(10, 50); count > 0; --count) {
      const dvec3 centre = anywhere(size);
      const double reach = one_of({0.05, 0.2, 0.5}) * size;
      const auto corner = [&] { return centre + dvec3(real(-reach, reach), real(-reach, reach), real(-reach, reach)); };
      const dvec3 a = corner(), b = corner();
      add({a, b, corner()}, random_.between(0, 2));
    }
  }

  [[nodiscard]] LatticeRandom& random() { return random_; }

  scene::Scene take() const {
    scene::SceneBuilder builder("scene.obj", "obj");
    builder.add_section({"scene.obj", "", scene::RecordKind::Line});
    for (const Drawn& face : faces_) {
      builder.use_material(builder.material("material" + std::to_string(face.material)));
      std::vector<scene::VertexId> ids;
      for (const dvec3& p : face.corners) ids.push_back(builder.add_vertex(p));
      builder.add_face(ids, builder.scene().faces.size() + 1);
    }
    return builder.take();
  }

 private:
  using dvec3 = geom::dvec3;
  using Corners = std::vector<dvec3>;
  struct Drawn {
    Corners corners;
    std::int64_t material = 0;
  };

  double real(double low, double high) { return low + (high - low) * random_.unit(); }
  double one_of(std::initializer_list<double> values) {
    return *(values.begin() + random_.between(0, static_cast<std::int64_t>(values.size()) - 1));
  }
  dvec3 anywhere(double size) {
    const double x = real(0, size), y = real(0, size);
    return {x, y, real(0, size)};
  }

  glm::dmat3 rotation() {
    while (true) {
      const double w = real(-1, 1), x = real(-1, 1), y = real(-1, 1);
      const glm::dquat q(w, x, y, real(-1, 1));
      const double squared = glm::dot(q, q);
      if (squared > 0.01 && squared < 1) return glm::mat3_cast(glm::normalize(q));
    }
  }
  static glm::dmat3 about_z(double angle) {
    return {{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
  }

  void transform(std::size_t first, const glm::dmat3& turn, const dvec3& by) {
    for (std::size_t i = first; i < faces_.size(); ++i) {
      for (dvec3& p : faces_[i].corners) p = turn * p + by;
    }
  }
  void turn_freely(std::size_t first, std::int64_t one_in) {
    if (random_.one_in(one_in)) transform(first, rotation(), anywhere(1));
  }
  // Not at all, by an angle with rational sine and cosine, or in any way.
  void turn_somehow(std::size_t first) {
    const std::int64_t way = random_.between(0, 2);
    if (way == 1) transform(first, {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}, {0, 0, 0});
    if (way == 2) turn_freely(first, 1);
  }

  static Corners rectangle(double x0, double y0, double x1, double y1, double z) {
    return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
  }
  static Corners reversed(const Corners& corners) { return {corners.rbegin(), corners.rend()}; }

  void add(const Corners& corners, std::int64_t material) { faces_.push_back({corners, material}); }
  void add_either_way(const Corners& corners) {
    add(random_.one_in(3) ? reversed(corners) : corners, random_.between(0, 3));
  }
  void add_maybe_cut(const Corners& quad, std::int64_t material) {
    if (!random_.one_in(3)) return add(quad, material);
    add({quad[0], quad[1], quad[2]}, material);
    add({quad[0], quad[2], quad[3]}, material);
  }

  void box(const dvec3& low, const dvec3& high, std::int64_t material) {
    const auto corner = [&](unsigned bits) {
      return dvec3(bits & 1U ? high.x : low.x, bits & 2U ? high.y : low.y, bits & 4U ? high.z : low.z);
    };
    constexpr std::array<std::array<unsigned, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& side : kSides) {
      add_maybe_cut({corner(side[0]), corner(side[1]), corner(side[2]), corner(side[3])}, material);
    }
  }

  void tube() {
    const std::size_t first = faces_.size();
    const std::int64_t sides = random_.between(5, 24);
    const double radius = real(0.05, 0.4), start = real(0, 1);
    const dvec3 centre(real(-0.3, 0.3), real(-0.3, 0.3), 0);
    const auto at = [&](std::int64_t i, double z) {
      const double angle = start + 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
      return centre + dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    for (std::int64_t i = 0; i < sides; ++i) {
      add_maybe_cut({at(i, -0.4), at(i + 1, -0.4), at(i + 1, 0.4), at(i, 0.4)}, 1);
    }
    turn_freely(first, 2);
  }

  LatticeRandom random_;
  std::vector<Drawn> faces_;
};

struct HardKind {
  const char* name;
  void (HardScene::*draw)();

  friend std::ostream& operator<<(std::ostream& out, const HardKind& kind) { return out << kind.name; }
};

inline constexpr std::array<HardKind, 12> kHardKinds{{
    {"grid_boxes", &HardScene::grid_boxes},
    {"sheets", &HardScene::sheets},
    {"slabs", &HardScene::slabs},
    {"tilted_sheets", &HardScene::tilted_sheets},
    {"shifted_copies", &HardScene::shifted_copies},
    {"walls", &HardScene::walls},
    {"pierced_slab", &HardScene::pierced_slab},
    {"needles", &HardScene::needles},
    {"comb", &HardScene::comb},
    {"cylinders", &HardScene::cylinders},
    {"planes_near_a_point", &HardScene::planes_near_a_point},
    {"soup", &HardScene::soup},
}};

/// One kind alone, or for every fourth seed mixed with another.
inline scene::Scene hard_scene(const HardKind& kind, std::uint64_t seed) {
  HardScene scene(seed);
  (scene.*kind.draw)();
  if (seed % 4 == 3) {
    const auto other = static_cast<std::size_t>(scene.random().between(0, kHardKinds.size() - 1));
    (scene.*kHardKinds[other].draw)();
  }
  return scene.take();
}

}  // namespace rad::tests
