// What covers each triangle of a plane map, against counting the edges that a ray crosses.
#include "repair/cluster_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "repair/normaliser.h"
#include "tests/repair/drawn_complex.h"
#include "tests/support/lattice_random.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 16;
const dvec3 kUp{0, 0, 1};

geom::Int128 doubled_area(const geom::PlanarPoint& a, const geom::PlanarPoint& b, const geom::PlanarPoint& c) {
  return geom::Int128{b.u - a.u} * (c.v - a.v) - geom::Int128{b.v - a.v} * (c.u - a.u);
}

geom::PlanarPoint times_three(const geom::PlanarPoint& p) { return {3 * p.u, 3 * p.v}; }

// Whether an odd number of the piece's edges lies to the right of the point, which is given three times as large.
bool odd(const Complex& complex, const Cluster& cluster, PieceId piece, const geom::PlanarPoint& p) {
  bool inside = false;
  for (const EdgeKey edge : cluster.edges) {
    const auto items = complex.items(edge);
    if (std::find(items.begin(), items.end(), Item::piece(piece)) == items.end()) continue;
    const auto [a, b] = ends_of(edge);
    auto low = times_three(cluster.plane.project(complex.point(a)));
    auto high = times_three(cluster.plane.project(complex.point(b)));
    if (low.v > high.v) std::swap(low, high);
    if (low.v <= p.v && p.v < high.v && doubled_area(low, high, p) > 0) inside = !inside;
  }
  return inside;
}

void expect_covers_agree(const Complex& complex, ClusterId id) {
  const Cluster& cluster = complex.clusters()[id];
  const ClusterMap map(complex, id);
  for (std::size_t i = 0; i < map.triangles().size(); ++i) {
    const auto points = map.points(i);
    geom::PlanarPoint sum{};
    for (const PointId point : points) {
      const auto flat = cluster.plane.project(complex.point(point));
      sum = {sum.u + flat.u, sum.v + flat.v};
    }
    std::vector<PieceId> expected;
    for (PieceId piece = 0; piece < complex.pieces().size(); ++piece) {
      if (complex.pieces()[piece].cluster == id && odd(complex, cluster, piece, sum)) expected.push_back(piece);
    }
    ASSERT_EQ(map.covers()[map.cover(i)], expected) << "triangle " << i;
  }
}

// Pieces of several corners in the plane x + 2y + 2z = 0, normalised; every other one crosses itself.
void draw_random_pieces(tests::ComplexSketch& sketch, ClusterId cluster, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  const auto on_plane = [&] {
    const auto u = static_cast<std::int32_t>(random.between(-4, 4)) * 100;
    const auto v = static_cast<std::int32_t>(random.between(-4, 4)) * 100;
    return LatticePoint{2 * u + 2 * v, u - 2 * v, -2 * u + v};
  };
  for (std::int64_t i = random.between(1, 8); i > 0; --i) {
    std::vector<LatticePoint> ring;
    for (std::int64_t count = random.between(3, 7); count > 0; --count) ring.push_back(on_plane());
    sketch.piece(cluster, ring);
  }
  Normaliser(sketch.complex).run(sketch.complex.weld_distance());
}

TEST(ClusterMap, KnowsWhatCoversEachTriangle) {
  std::size_t triangles = 0, most = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(seed);
    tests::ComplexSketch sketch(kTolerance);
    const ClusterId cluster = sketch.plane({1, 2, 2});
    draw_random_pieces(sketch, cluster, seed);
    expect_covers_agree(sketch.complex, cluster);
    const ClusterMap map(sketch.complex, cluster);
    EXPECT_TRUE(map.stacking().points.empty());
    EXPECT_FALSE(map.stacking().crossing);
    triangles += map.triangles().size();
    for (const auto& cover : map.covers()) most = std::max(most, cover.size());
  }
  EXPECT_GT(triangles, 3000u);
  EXPECT_GE(most, 5u);
}

// Other clusters' pieces on common edges cover nothing here.
TEST(ClusterMap, HeedsOnlyItsOwnPieces) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp), wall = sketch.plane({0, 1, 0});
  const PieceId a = sketch.piece(floor, {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}});
  sketch.piece(wall, {{0, 0, 0}, {1000, 0, 0}, {1000, 0, 1000}});
  const ClusterMap map(sketch.complex, floor);
  ASSERT_EQ(map.triangles().size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(map.covers()[map.cover(i)], std::vector{a});
}

TEST(ClusterMap, HasAHoleWhereAPieceHasOne) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  const PieceId frame = sketch.piece(floor, {{0, 0, 0}, {3000, 0, 0}, {3000, 3000, 0}, {0, 3000, 0}});
  sketch.draw({{1000, 1000, 0}, {2000, 1000, 0}, {2000, 2000, 0}, {1000, 2000, 0}}, frame);
  const ClusterMap map(sketch.complex, floor);
  std::size_t empty = 0;
  for (std::size_t i = 0; i < map.triangles().size(); ++i) empty += map.cover(i) == 0 ? 1 : 0;
  EXPECT_EQ(empty, 2u);
  expect_covers_agree(sketch.complex, floor);
}

TEST(ClusterMap, TellsOfStackedPoints) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  sketch.piece(floor, {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}});
  sketch.piece(floor, {{0, 0, 20}, {-1000, 0, 0}, {-1000, 500, 0}});
  const auto stacked = ClusterMap(sketch.complex, floor).stacking().points;
  ASSERT_EQ(stacked.size(), 1u);
  EXPECT_EQ(std::set(stacked[0].begin(), stacked[0].end()),
            (std::set{sketch.point({0, 0, 0}), sketch.point({0, 0, 20})}));
}

TEST(ClusterMap, TellsOfAPointOverAnEdgeAndOfCrossings) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  sketch.piece(floor, {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}});
  sketch.piece(floor, {{500, 0, 20}, {600, -900, 0}, {400, -900, 0}});
  const Stacking over = ClusterMap(sketch.complex, floor).stacking();
  ASSERT_EQ(over.points_on_edges.size(), 1u);
  EXPECT_EQ(over.points_on_edges[0].first, edge_key(sketch.point({0, 0, 0}), sketch.point({1000, 0, 0})));
  EXPECT_EQ(over.points_on_edges[0].second, sketch.point({500, 0, 20}));
  EXPECT_FALSE(over.crossing);
  sketch.piece(floor, {{700, 500, 0}, {800, -500, 0}, {750, -500, 0}});
  EXPECT_TRUE(ClusterMap(sketch.complex, floor).stacking().crossing);
}

// A diagonal that passes a corner of its quadrilateral within T, where the other one does not.
TEST(ClusterMap, FlipsASliverWhereThatIsBetter) {
  tests::ComplexSketch sketch(kTolerance);
  const ClusterId floor = sketch.plane(kUp);
  const PieceId piece = sketch.piece(floor, {{0, 0, 0}, {1000, -10, 0}, {2000, 0, 0}, {1000, 3000, 0}});
  ClusterMap map(sketch.complex, floor);
  map.flip_slivers(kTolerance);
  ASSERT_EQ(map.triangles().size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto points = map.points(i);
    EXPECT_EQ(std::ranges::count(points, sketch.point({1000, -10, 0})), 1);
    EXPECT_EQ(std::ranges::count(points, sketch.point({1000, 3000, 0})), 1);
    EXPECT_EQ(map.covers()[map.cover(i)], std::vector{piece});
  }
}

TEST(ClusterMap, FlipsKeepCovers) {
  for (std::uint64_t seed = 200; seed <= 260; ++seed) {
    SCOPED_TRACE(seed);
    tests::ComplexSketch sketch(kTolerance);
    const ClusterId cluster = sketch.plane({1, 2, 2});
    draw_random_pieces(sketch, cluster, seed);
    const auto covered_area = [&](const ClusterMap& map) {
      std::map<std::vector<PieceId>, double> area;
      for (std::size_t i = 0; i < map.triangles().size(); ++i) {
        const auto p = map.points(i);
        const Plane& plane = sketch.complex.clusters()[cluster].plane;
        area[map.covers()[map.cover(i)]] += static_cast<double>(
            doubled_area(plane.project(sketch.complex.point(p[0])), plane.project(sketch.complex.point(p[1])),
                         plane.project(sketch.complex.point(p[2]))));
      }
      return area;
    };
    ClusterMap map(sketch.complex, cluster);
    const auto before = covered_area(map);
    map.flip_slivers(20 * kTolerance);
    EXPECT_EQ(covered_area(map), before);
  }
}

}  // namespace
}  // namespace rad::repair
