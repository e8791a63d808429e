// The residual loop: one violation of each kind is cured.
#include "repair/residual.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "repair/normaliser.h"
#include "tests/repair/drawn_complex.h"
#include "tests/repair/whole_lint.h"

namespace rad::repair {
namespace {

constexpr std::int64_t kTolerance = 32;
const dvec3 kUp{0, 0, 1};

class ResidualSketch : public tests::ComplexSketch {
 public:
  ResidualSketch() : ComplexSketch(static_cast<double>(kTolerance)), residual(complex) {}

  std::vector<Violation> judge() {
    triangulation.update(complex);
    return tests::lint_triangles(
        {complex.points(), triangulation.triangles(), triangulation.alive(), triangulation.folded()}, kTolerance);
  }

  bool round(Effort effort = Effort::OneKind) {
    const std::vector<Violation> found = judge();
    const bool changed = residual.round(triangulation, found, effort, complex.weld_distance());
    Normaliser(complex).run(complex.weld_distance());
    return changed;
  }

  // Rounds until nothing is left; how many there were.
  int rounds() {
    for (int count = 0; count < 20; ++count) {
      if (judge().empty() && triangulation.sound()) return count;
      if (!round() && !round(Effort::AllKinds) && !round(Effort::Forced) && !round(Effort::Merge)) return -1;
    }
    return -1;
  }

  [[nodiscard]] std::size_t triangles_in(ClusterId cluster) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        triangulation.of_cluster(cluster), [&](std::uint32_t i) { return triangulation.alive()[i] != 0; }));
  }

  Residual residual;
  Triangulation triangulation;
};

std::size_t of_kind(const std::vector<Violation>& all, ViolationKind kind) {
  return static_cast<std::size_t>(std::ranges::count(all, kind, &Violation::kind));
}

TEST(Residual, SplitsAnEdgeAtThePointOnIt) {
  ResidualSketch sketch;
  const PieceId piece = sketch.piece(sketch.plane(kUp), {{0, 0, 0}, {4000, 0, 0}, {2000, 3000, 0}});
  sketch.piece(sketch.plane({0, 1, 0}), {{2000, 0, 0}, {2500, 0, -2000}, {1500, 0, -2000}});
  EXPECT_EQ(of_kind(sketch.judge(), ViolationKind::Intersection), 1u);
  EXPECT_GT(sketch.rounds(), 0);
  EXPECT_TRUE(sketch.carries({0, 0, 0}, {2000, 0, 0}, Item::piece(piece)));
}

TEST(Residual, CutsTwoTrianglesThatCross) {
  ResidualSketch sketch;
  const ClusterId floor = sketch.plane(kUp), wall = sketch.plane({0, 1, 0}, {0, 1000, 0});
  sketch.piece(floor, {{0, 0, 0}, {6000, 0, 0}, {0, 6000, 0}});
  sketch.piece(wall, {{1000, 1000, -500}, {2000, 1000, -500}, {1500, 1000, 700}});
  EXPECT_GT(sketch.rounds(), 0);
  EXPECT_GE(sketch.triangles_in(floor), 4u);
  EXPECT_GE(sketch.triangles_in(wall), 2u);
  EXPECT_EQ(sketch.residual.counts().rehomed, 0u);
}

// A sheet that hovers the floor within T, in a plane of its own: it becomes part of the floor, and covers it there.
TEST(Residual, RehomesWhatNearlyCoincides) {
  ResidualSketch sketch;
  const ClusterId floor = sketch.plane(kUp), sheet = sketch.plane(kUp, {0, 0, 20});
  const PieceId below = sketch.piece(floor, {{0, 0, 0}, {6000, 0, 0}, {6000, 6000, 0}, {0, 6000, 0}});
  const PieceId above = sketch.piece(sheet, {{1000, 1000, 20}, {3000, 1000, 20}, {1000, 3000, 20}});
  EXPECT_GT(of_kind(sketch.judge(), ViolationKind::NearCoplanar), 0u);
  EXPECT_GT(sketch.rounds(), 0);
  EXPECT_EQ(sketch.residual.counts().rehomed, 1u);
  EXPECT_EQ(sketch.triangles_in(sheet), 0u);
  EXPECT_FALSE(sketch.carries({1000, 1000, 20}, {3000, 1000, 20}, Item::piece(above)));
  const auto moved = static_cast<PieceId>(sketch.complex.pieces().size() - 1);
  EXPECT_EQ(sketch.complex.pieces()[moved].cluster, floor);
  EXPECT_EQ(sketch.complex.pieces()[moved].rank, sketch.complex.pieces()[above].rank);
  const bool covered = std::ranges::any_of(sketch.triangulation.living(), [&](std::uint32_t i) {
    return sketch.triangulation.cover_of(sketch.triangulation.triangles()[i]) == std::vector{below, moved};
  });
  EXPECT_TRUE(covered);
}

// Turned by more than 45° it is no part of the floor, however near it is.
TEST(Residual, DoesNotRehomeWhatStandsUpright) {
  ResidualSketch sketch;
  const ClusterId floor = sketch.plane(kUp);
  sketch.piece(floor, {{0, 0, 0}, {6000, 0, 0}, {6000, 6000, 0}, {0, 6000, 0}});
  sketch.piece(sketch.plane({0, 1, 0}, {0, 1000, 0}), {{1000, 1000, -30}, {3000, 1000, -30}, {2000, 1000, 50}});
  sketch.rounds();
  EXPECT_EQ(sketch.residual.counts().rehomed, 0u);
}

// Both diagonals of a narrow kite pass a corner: only a new point helps.
TEST(Residual, RelievesASliver) {
  ResidualSketch sketch;
  const ClusterId floor = sketch.plane(kUp);
  std::vector<LatticePoint> ring{{0, 0, 0}};
  for (int i = 1; i < 12; ++i) ring.push_back({500 * i, i % 2 == 0 ? 10 : -10, 0});
  ring.insert(ring.end(), {{6000, 0, 0}, {6000, 5000, 0}, {0, 5000, 0}});
  sketch.piece(floor, ring);
  Normaliser(sketch.complex).run(sketch.complex.weld_distance());
  const int rounds = sketch.rounds();
  EXPECT_GE(rounds, 0);
  EXPECT_TRUE(sketch.judge().empty());
}

TEST(Residual, MergesStackedPoints) {
  ResidualSketch sketch;
  const ClusterId floor = sketch.plane(kUp);
  sketch.piece(floor, {{0, 0, 0}, {3000, 0, 0}, {3000, 3000, 0}});
  sketch.piece(floor, {{0, 0, 40}, {-3000, 0, 0}, {-3000, 1500, 0}});
  sketch.triangulation.update(sketch.complex);
  EXPECT_FALSE(sketch.triangulation.sound());
  EXPECT_GT(sketch.rounds(), 0);
  EXPECT_EQ(sketch.complex.counts().merges, 1u);
  EXPECT_TRUE(sketch.complex.live(sketch.point({0, 0, 0}))) << "the first in space stays";
}

TEST(Residual, ChangesNothingWhereNothingIsWrong) {
  ResidualSketch sketch;
  sketch.piece(sketch.plane(kUp), {{0, 0, 0}, {4000, 0, 0}, {2000, 3000, 0}});
  for (const Effort effort : {Effort::OneKind, Effort::AllKinds, Effort::Forced, Effort::Merge}) {
    EXPECT_FALSE(sketch.round(effort));
  }
}

}  // namespace
}  // namespace rad::repair
