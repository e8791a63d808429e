// Edges against planes: contacts and chords are imprinted in all that they touch.
#include "repair/isect.h"

#include <gtest/gtest.h>

#include <cmath>

#include "repair/normaliser.h"
#include "repair/triangle_lint.h"
#include "tests/repair/drawn_complex.h"
#include "tests/repair/whole_lint.h"
#include "tests/support/lattice_random.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 32;

class CutSketch : public tests::ComplexSketch {
 public:
  CutSketch() : ComplexSketch(kTolerance) {}

  void quad(const dvec3& normal, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
            const LatticePoint& d) {
    piece(plane(normal, a), {a, b, c, d});
  }

  // A box without bottom, between two corners.
  void sides_of_box(const LatticePoint& l, const LatticePoint& h) {
    quad({0, -1, 0}, {l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
    quad({1, 0, 0}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z});
    quad({0, 1, 0}, {h.x, h.y, l.z}, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z});
    quad({-1, 0, 0}, {l.x, h.y, l.z}, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z});
    quad({0, 0, 1}, {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});
  }

  // Passes until nothing changes; the number of those that changed something.
  int cut() {
    Normaliser normaliser(complex);
    normaliser.run(complex.weld_distance());
    Isect isect(complex);
    for (int round = 0; round < 8; ++round) {
      triangulation.update(complex);
      const bool cut = isect.pass(triangulation);
      if (!normaliser.run(complex.weld_distance()) && !cut) return round;
    }
    return 8;
  }

  [[nodiscard]] std::size_t intersections() {
    triangulation.update(complex);
    const auto found = tests::lint_triangles(
        {complex.points(), triangulation.triangles(), triangulation.alive(), triangulation.folded()},
        static_cast<std::int64_t>(kTolerance));
    return static_cast<std::size_t>(std::ranges::count(found, ViolationKind::Intersection, &Violation::kind));
  }

  Triangulation triangulation;
};

CutSketch on_a_floor() {
  CutSketch sketch;
  sketch.quad({0, 0, 1}, {0, 0, 0}, {9000, 0, 0}, {9000, 9000, 0}, {0, 9000, 0});
  return sketch;
}

TEST(Isect, ImprintsABoxOnTheFloor) {
  CutSketch sketch = on_a_floor();
  sketch.sides_of_box({2000, 2000, 0}, {4000, 5000, 3000});
  EXPECT_GE(sketch.cut(), 1);
  const Item in_floor = Item::imprint(0);
  EXPECT_TRUE(sketch.carries({2000, 2000, 0}, {4000, 2000, 0}, in_floor));
  EXPECT_TRUE(sketch.carries({4000, 2000, 0}, {4000, 5000, 0}, in_floor));
  EXPECT_TRUE(sketch.carries({4000, 5000, 0}, {2000, 5000, 0}, in_floor));
  EXPECT_TRUE(sketch.carries({2000, 5000, 0}, {2000, 2000, 0}, in_floor));
  EXPECT_EQ(sketch.complex.counts().new_points, 0u);
  EXPECT_EQ(sketch.intersections(), 0u);
}

TEST(Isect, CutsABoxThroughTheFloor) {
  CutSketch sketch = on_a_floor();
  sketch.sides_of_box({2000, 2000, -1000}, {4000, 5000, 3000});
  sketch.cut();
  EXPECT_EQ(sketch.complex.counts().new_points, 4u);
  EXPECT_TRUE(sketch.carries({2000, 2000, 0}, {4000, 2000, 0}, Item::imprint(0)));
  EXPECT_TRUE(sketch.carries({2000, 2000, 0}, {4000, 2000, 0}, Item::imprint(1)));
  EXPECT_TRUE(sketch.carries({2000, 5000, 0}, {2000, 2000, 0}, Item::imprint(0)));
  EXPECT_TRUE(sketch.carries({2000, 5000, 0}, {2000, 2000, 0}, Item::imprint(4)));
  EXPECT_EQ(sketch.intersections(), 0u);
}

TEST(Isect, ImprintsAWallThatEndsOnTheFloor) {
  CutSketch sketch = on_a_floor();
  sketch.quad({0, 1, 0}, {-1000, 3000, 0}, {5000, 3000, 0}, {5000, 3000, 2000}, {-1000, 3000, 2000});
  sketch.cut();
  EXPECT_TRUE(sketch.carries({0, 3000, 0}, {5000, 3000, 0}, Item::imprint(0)));
  EXPECT_TRUE(sketch.carries({0, 3000, 0}, {-1000, 3000, 0}, Item::piece(1)));
  EXPECT_EQ(sketch.intersections(), 0u);
}

TEST(Isect, LeavesAWallThatHoversOverTheFloor) {
  CutSketch sketch = on_a_floor();
  sketch.quad({0, 1, 0}, {1000, 3000, 40}, {5000, 3000, 40}, {5000, 3000, 2000}, {1000, 3000, 2000});
  EXPECT_EQ(sketch.cut(), 0);
  EXPECT_EQ(sketch.complex.counts().imprints, 0u);
}

TEST(Isect, LeavesAnEdgeThatPassesTheFloorOutside) {
  CutSketch sketch = on_a_floor();
  sketch.quad({1, 0, 0}, {-100, 0, -1000}, {-100, 9000, -1000}, {-100, 9000, 1000}, {-100, 0, 1000});
  EXPECT_EQ(sketch.cut(), 0);
}

TEST(Isect, CutsAWallThatStandsThroughAHoleOnlyAtItsRim) {
  CutSketch sketch = on_a_floor();
  sketch.draw({{3000, 3000, 0}, {6000, 3000, 0}, {6000, 6000, 0}, {3000, 6000, 0}}, 0);
  sketch.quad({0, 1, 0}, {4000, 4000, -1000}, {8000, 4000, -1000}, {8000, 4000, 1000}, {4000, 4000, 1000});
  sketch.cut();
  EXPECT_TRUE(sketch.carries({6000, 4000, 0}, {8000, 4000, 0}, Item::imprint(0)));
  EXPECT_TRUE(sketch.carries({6000, 4000, 0}, {8000, 4000, 0}, Item::imprint(1)));
  EXPECT_FALSE(sketch.complex.has_edge(edge_key(sketch.point({4000, 4000, 0}), sketch.point({6000, 4000, 0}))));
  EXPECT_EQ(sketch.intersections(), 0u);
}

// Three sheets whose planes meet in one point, and nearly so.
TEST(Isect, BringsThreePlanesToOnePoint) {
  for (const std::int32_t off : {0, 5, 20}) {
    SCOPED_TRACE(off);
    CutSketch sketch;
    constexpr std::int32_t k = 4000;
    sketch.quad({0, 0, 1}, {-k, -k, 0}, {k, -k, 0}, {k, k, 0}, {-k, k, 0});
    sketch.quad({0, 1, 0}, {-k, off, -k}, {k, off, -k}, {k, off, k}, {-k, off, k});
    sketch.quad({1, -1, 0}, {-k, -k, -k}, {k, k, -k}, {k, k, k}, {-k, -k, k});
    sketch.cut();
    EXPECT_EQ(sketch.intersections(), 0u);
    std::size_t near = 0;
    for (PointId id = 0; id < sketch.complex.point_count(); ++id) {
      const bool close = glm::length(sketch.complex.place(id)) < 2 * sketch.complex.weld_distance();
      near += close && sketch.complex.live(id) ? 1 : 0;
    }
    EXPECT_EQ(near, 1u);
  }
}

TEST(Isect, CutsSheetsInAnyDirection) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    CutSketch sketch;
    for (int i = 0; i < 5; ++i) {
      const LatticePoint a = random.grid_point(40, 100), b = random.grid_point(40, 100), c = random.grid_point(40, 100);
      if (geom::collinear(a, b, c)) continue;
      const dvec3 normal = glm::cross(geom::as_vector(b) - geom::as_vector(a), geom::as_vector(c) - geom::as_vector(a));
      sketch.piece(sketch.plane(normal, a), {a, b, c});
    }
    const std::size_t before = sketch.intersections();
    sketch.cut();
    EXPECT_LE(sketch.intersections(), before / 4) << "what is left is for the residual loop";
    EXPECT_EQ(tests::points_on_edges(sketch.complex), 0u);
  }
}

}  // namespace
}  // namespace rad::repair
