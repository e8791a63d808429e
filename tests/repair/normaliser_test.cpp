// Insertion of T-vertices and cutting of crossings, checked by brute force.
#include "repair/normaliser.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "repair/weld.h"
#include "tests/repair/drawn_complex.h"
#include "tests/support/lattice_random.h"
#include "tests/support/scene_variants.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 32;

const dvec3 kUp{0, 0, 1};

bool normalise(Complex& complex) { return Normaliser(complex).run(complex.weld_distance()); }

LatticePoint rounded(double x, double y, double z = 0) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y)),
          static_cast<std::int32_t>(std::lround(z))};
}

void expect_normal(const Complex& complex) {
  EXPECT_EQ(tests::points_on_edges(complex), 0u);
  EXPECT_EQ(tests::crossings(complex), 0u);
}

// Fig. 2 of the paper: the triangle A,D,E becomes A,C,D,E.
TEST(Normaliser, InsertsTheTVertexOfThePaper) {
  tests::ComplexSketch sketch(kTolerance);
  const LatticePoint a{0, 0, 0}, b{-3000, 2000, 0}, c{0, 2000, 0}, d{0, 4000, 0}, e{3000, 2000, 0};
  const ClusterId floor = sketch.plane(kUp);
  sketch.piece(floor, {a, c, b});
  sketch.piece(floor, {c, d, b});
  const PieceId right = sketch.piece(floor, {a, e, d});
  EXPECT_TRUE(normalise(sketch.complex));
  EXPECT_TRUE(sketch.carries(a, c, Item::piece(right)));
  EXPECT_TRUE(sketch.carries(c, d, Item::piece(right)));
  EXPECT_FALSE(sketch.complex.has_edge(edge_key(sketch.point(a), sketch.point(d))));
  EXPECT_EQ(sketch.complex.counts().splits, 1u);
  expect_normal(sketch.complex);
  EXPECT_FALSE(normalise(sketch.complex));
}

TEST(Normaliser, LeavesAPointBeyondT) {
  for (const std::int32_t height : {31, 32, 33, 34}) {
    tests::ComplexSketch sketch(kTolerance);
    const ClusterId floor = sketch.plane(kUp);
    sketch.piece(floor, {{0, 0, 0}, {4000, 0, 0}, {2000, -3000, 0}});
    sketch.piece(floor, {{2000, height, 0}, {4000, 3000, 0}, {0, 3000, 0}});
    EXPECT_EQ(normalise(sketch.complex), height <= kTolerance);
  }
}

TEST(Normaliser, SplitsAnEdgeAtTenThousandPoints) {
  constexpr int kTeeth = 10000, spacing = 200;
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  const LatticePoint from{-spacing, 0, 0}, to{kTeeth * spacing, 0, 0};
  std::mt19937 random(3);
  for (const std::uint32_t i : tests::shuffled(kTeeth, random)) {
    const auto x = static_cast<std::int32_t>(i) * spacing;
    sketch.piece(floor, {{x, 0, 0}, {x + spacing / 2, 500, 0}, {x - spacing / 2, 500, 0}});
  }
  const PieceId long_piece = sketch.piece(floor, {from, {1000000, -900000, 0}, to});
  normalise(sketch.complex);
  for (int i = -1; i < kTeeth; ++i) {
    ASSERT_TRUE(sketch.carries({i * spacing, 0, 0}, {(i + 1) * spacing, 0, 0}, Item::piece(long_piece)));
  }
  EXPECT_EQ(sketch.complex.counts().splits, kTeeth);
  EXPECT_EQ(sketch.complex.counts().merges, 0u);
}

// Teeth as close as welding leaves them, at either side of a long edge.
TEST(Normaliser, MakesACombOneLine) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  const auto pitch = static_cast<int>(std::ceil(1.01 * 1.16 * kTolerance));
  for (int i = 0; i < 100; ++i) {
    const int x = i * pitch, off = i % 3 * 12 - 12;
    sketch.piece(floor, {{x, off, 0}, {x + pitch, 2000, 0}, {x, 2000, 0}});
  }
  sketch.piece(floor, {{-500, 0, 0}, {0, -3000, 0}, {101 * pitch, 0, 0}});
  normalise(sketch.complex);
  expect_normal(sketch.complex);
}

TEST(Normaliser, JoinsTwoEdgesHalfTApart) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  std::vector<LatticePoint> below{{-5000, -4000, 0}}, above{{-5000, 4000, 0}};
  for (int i = 0; i <= 20; ++i) {
    below.push_back({i * 400, 0, 0});
    above.push_back({i * 400 + 170, 16, 0});
  }
  sketch.piece(floor, below);
  sketch.piece(floor, above);
  normalise(sketch.complex);
  expect_normal(sketch.complex);
  EXPECT_GE(sketch.complex.counts().splits, 38u);
}

// A fan of edges from one point that part from each other by less and less.
TEST(Normaliser, OpensAFanOfNearlyParallelEdges) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  for (int i = 0; i < 12; ++i) {
    const double angle = std::pow(10, -0.5 * i);
    const double length = 20000 + 500 * i;
    const LatticePoint tip = rounded(length * std::cos(angle), length * std::sin(angle));
    sketch.piece(floor, {{0, 0, 0}, tip, {-3000, -2000 + 300 * i, 0}});
  }
  normalise(sketch.complex);
  expect_normal(sketch.complex);
}

TEST(Normaliser, GivesCrossingEdgesACommonPoint) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  const PieceId a = sketch.piece(floor, {{0, 0, 0}, {4000, 0, 0}, {4000, 4000, 0}, {0, 4000, 0}});
  const PieceId b = sketch.piece(floor, {{2000, 2000, 0}, {6000, 2000, 0}, {6000, 6000, 0}, {2000, 6000, 0}});
  normalise(sketch.complex);
  expect_normal(sketch.complex);
  EXPECT_TRUE(sketch.carries({4000, 2000, 0}, {4000, 0, 0}, Item::piece(a)));
  EXPECT_TRUE(sketch.carries({4000, 2000, 0}, {2000, 2000, 0}, Item::piece(b)));
  EXPECT_EQ(sketch.complex.counts().new_points, 2u);
}

// Edges of different clusters that pass each other are no crossing.
TEST(Normaliser, LeavesEdgesOfDifferentPlanes) {
  tests::ComplexSketch sketch(kTolerance);
  sketch.piece(sketch.plane(kUp), {{0, 0, 0}, {4000, 0, 0}, {2000, 3000, 0}});
  sketch.piece(sketch.plane(kUp, {0, 0, 500}), {{2000, -1000, 500}, {2000, 2000, 500}, {500, 0, 500}});
  EXPECT_FALSE(normalise(sketch.complex));
}

TEST(Normaliser, SplitsOrMerges) {
  tests::ComplexSketch sketch(kTolerance);
  const PieceId piece = sketch.piece(sketch.plane(kUp), {{0, 0, 0}, {4000, 0, 0}, {2000, 3000, 0}});
  split_or_merge(sketch.complex, edge_key(0, 1), sketch.point({1000, 5, 0}));
  EXPECT_TRUE(sketch.carries({0, 0, 0}, {1000, 5, 0}, Item::piece(piece)));
  const PointId beyond = sketch.point({-20, 0, 0});
  split_or_merge(sketch.complex, edge_key(0, 3), beyond);
  EXPECT_FALSE(sketch.complex.live(0));
  EXPECT_TRUE(sketch.complex.live(beyond));
}

void draw_random_pieces(tests::ComplexSketch& sketch, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  const ClusterId floor = sketch.plane({1, 2, 2});
  const auto on_plane = [&] {
    const auto u = static_cast<std::int32_t>(random.between(-300, 300));
    const auto v = static_cast<std::int32_t>(random.between(-300, 300));
    return LatticePoint{2 * u + 2 * v, u - 2 * v, -2 * u + v};
  };
  std::vector<LatticePoint> points;
  for (int i = 0; i < 24; ++i) points.push_back(on_plane());
  const std::vector<std::uint32_t> welded = weld(points, kTolerance);
  for (int i = 0; i < 8; ++i) {
    std::vector<LatticePoint> ring;
    for (std::int64_t count = random.between(3, 6); count > 0; --count) {
      ring.push_back(points[welded[static_cast<std::size_t>(random.between(0, 23))]]);
    }
    sketch.piece(floor, ring);
  }
}

RC_GTEST_PROP(NormaliserProperty, LeavesNothingOnEdgesAndNoCrossing, (std::uint64_t seed)) {
  tests::ComplexSketch sketch(kTolerance);
  draw_random_pieces(sketch, seed);
  normalise(sketch.complex);
  RC_ASSERT(tests::points_on_edges(sketch.complex) == 0u);
  RC_ASSERT(tests::crossings(sketch.complex) == 0u);
  RC_ASSERT(!normalise(sketch.complex));
}

// Every piece stays a closed chain: at each point an even number of its edges ends.
RC_GTEST_PROP(NormaliserProperty, KeepsPiecesClosed, (std::uint64_t seed)) {
  tests::ComplexSketch sketch(kTolerance);
  draw_random_pieces(sketch, seed);
  normalise(sketch.complex);
  std::map<std::pair<PieceId, PointId>, int> ends;
  for (const EdgeKey edge : sketch.complex.edges()) {
    for (const Item item : sketch.complex.items(edge)) {
      for (const PointId id : ends_of(edge)) ++ends[{item.piece_id(), id}];
    }
  }
  for (const auto& [key, count] : ends) RC_ASSERT(count % 2 == 0);
}

}  // namespace
}  // namespace rad::repair
