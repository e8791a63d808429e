// Air cells against flood fill: complexes of tetrahedra with random walls, of which the cells are known beforehand.
#include "validate/air_cells.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "geom/radial_order.h"
#include "scene/disjoint_sets.h"
#include "tests/support/lattice_random.h"
#include "tests/validate/tetrahedral_walls.h"

namespace rad::validate {
namespace {

using geom::Int128;
using geom::LatticePoint;
using scene::PointId;
using tests::Corners;
using tests::TetrahedralWalls;
using tests::Walls;

AirCells cells_of(const Walls& walls) { return find_air_cells(walls.points, walls.triangles).value(); }

TEST(AirCells, AreThoseOfFloodFill) {
  std::size_t bounded = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TetrahedralWalls known(seed, 0.3 + 0.6 * static_cast<double>(seed % 10) / 9);
    const AirCells cells = cells_of(known.walls);
    std::map<std::uint32_t, CellId> cell_of_region{{known.outside(), kOpenSpace}};
    std::set<CellId> seen{kOpenSpace};
    for (std::size_t i = 0; i < known.expected.size(); ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        const CellId cell = cells.cell_of_side[i][side];
        const auto [entry, fresh] = cell_of_region.emplace(known.expected[i][side], cell);
        ASSERT_EQ(entry->second, cell) << "wall " << i << " side " << side;
        if (fresh) {
          EXPECT_TRUE(seen.insert(cell).second) << "two regions are one cell";
        }
      }
    }
    ASSERT_EQ(cells.size(), seen.size());
    for (const auto& [region, cell] : cell_of_region) {
      EXPECT_TRUE(cell == kOpenSpace || cells.volume6[cell] == known.volume6[region]);
    }
    bounded += cells.size() - 1;
  }
  EXPECT_GT(bounded, 3000U);
}

// Points and triangles in another order, triangles turned over, space mirrored: the same cells on the same sides.
TEST(AirCells, DoNotDependOnOrderFacingOrThreads) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TetrahedralWalls known(seed, 0.6);
    const AirCells expected = cells_of(known.walls);
    std::mt19937_64 random(seed);
    std::vector<PointId> place(known.walls.points.size());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), random);
    std::vector<std::size_t> order(known.walls.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    Walls other;
    other.points.resize(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) other.points[place[i]] = known.walls.points[i];
    std::vector<bool> turned;
    for (const std::size_t from : order) {
      Corners t = known.walls.triangles[from];
      for (PointId& corner : t) corner = place[corner];
      turned.push_back(random() % 2 == 0);
      if (turned.back()) std::swap(t[0], t[1]);
      other.triangles.push_back(t);
    }
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1 + seed % 2);
    const AirCells cells = cells_of(other);
    EXPECT_TRUE(cells.volume6 == expected.volume6);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto& sides = expected.cell_of_side[order[i]];
      EXPECT_EQ(cells.cell_of_side[i][0], sides[turned[i] ? 1 : 0]);
      EXPECT_EQ(cells.cell_of_side[i][1], sides[turned[i] ? 0 : 1]);
    }
    Walls mirror = known.walls;
    for (LatticePoint& p : mirror.points) p.x = -p.x;
    const AirCells mirrored = cells_of(mirror);
    EXPECT_EQ(mirrored.size(), expected.size());
    std::map<CellId, CellId> twin;
    for (std::size_t i = 0; i < mirror.triangles.size(); ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        const CellId cell = expected.cell_of_side[i][side];
        const auto entry = twin.emplace(cell, mirrored.cell_of_side[i][1 - side]).first;
        EXPECT_EQ(entry->second, mirrored.cell_of_side[i][1 - side]);
      }
    }
  }
}

TEST(AirCells, OfASheetAreOpenSpace) {
  Walls walls;
  walls.add_quad(walls.add(0, 0, 0), walls.add(9, 0, 0), walls.add(9, 9, 1), walls.add(0, 9, 0));
  const AirCells cells = cells_of(walls);
  EXPECT_EQ(cells.size(), 1U);
  for (const auto& sides : cells.cell_of_side) EXPECT_EQ(sides, (std::array{kOpenSpace, kOpenSpace}));
}

TEST(AirCells, OfNothingAreOpenSpace) { EXPECT_EQ(cells_of({}).size(), 1U); }

TEST(AirCells, NestLikeDolls) {
  Walls walls;
  constexpr std::int64_t kDolls = 5;
  for (std::int64_t i = 1; i <= kDolls; ++i) walls.add_box(-i, i);
  const AirCells cells = cells_of(walls);
  ASSERT_EQ(cells.size(), static_cast<std::size_t>(kDolls) + 1);
  std::multiset<std::int64_t> volumes, expected;
  for (CellId cell = 1; cell < cells.size(); ++cell) volumes.insert(static_cast<std::int64_t>(cells.volume6[cell]));
  for (std::int64_t i = 1; i <= kDolls; ++i) expected.insert(48 * (i * i * i - (i - 1) * (i - 1) * (i - 1)));
  EXPECT_EQ(volumes, expected);
  for (std::size_t t = 0; t < 12; ++t) EXPECT_NE(cells.cell_of_side[t][0], cells.cell_of_side[t][1]);
}

TEST(AirCells, OfAThousandBoxesAreAThousand) {
  Walls walls;
  for (std::int64_t i = 0; i < 1000; ++i) {
    const std::size_t first = walls.points.size();
    walls.add_box(0, 6);
    for (std::size_t p = first; p < walls.points.size(); ++p) {
      walls.points[p].x += static_cast<std::int32_t>(10 * (i % 10));
      walls.points[p].y += static_cast<std::int32_t>(10 * (i / 10 % 10));
      walls.points[p].z += static_cast<std::int32_t>(10 * (i / 100));
    }
  }
  const AirCells cells = cells_of(walls);
  ASSERT_EQ(cells.size(), 1001U);
  for (CellId cell = 1; cell < cells.size(); ++cell) EXPECT_TRUE(cells.volume6[cell] == 6 * 216);
  for (const auto& sides : cells.cell_of_side) EXPECT_EQ(sides[0], kOpenSpace);
}

// One wall between two rooms: each of its sides is in a cell of its own.
TEST(AirCells, ShareAWall) {
  Walls walls;
  std::array<std::array<PointId, 4>, 3> ring{};
  for (int i = 0; i < 3; ++i) {
    ring[i] = {walls.add(i * 4, 0, 0), walls.add(i * 4, 4, 0), walls.add(i * 4, 4, 4), walls.add(i * 4, 0, 4)};
    walls.add_quad(ring[i][0], ring[i][1], ring[i][2], ring[i][3]);
  }
  for (int i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      walls.add_quad(ring[i][k], ring[i + 1][k], ring[i + 1][(k + 1) % 4], ring[i][(k + 1) % 4]);
    }
  }
  const AirCells cells = cells_of(walls);
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_TRUE(cells.volume6[1] == 6 * 64 && cells.volume6[2] == 6 * 64);
  const std::set<CellId> sides(cells.cell_of_side[2].begin(), cells.cell_of_side[2].end());
  EXPECT_EQ(sides, (std::set<CellId>{1, 2}));
}

Walls torus(std::int64_t large, std::int64_t small, int steps) {
  Walls walls;
  const auto at = [&](int i, int j) { return static_cast<PointId>(i % steps * steps + j % steps); };
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double u = 2 * std::numbers::pi * i / steps, v = 2 * std::numbers::pi * j / steps;
      const double radius = static_cast<double>(large) + static_cast<double>(small) * std::cos(v);
      walls.add(std::lround(radius * std::cos(u)), std::lround(radius * std::sin(u)),
                std::lround(static_cast<double>(small) * std::sin(v)));
    }
  }
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) walls.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return walls;
}

TEST(AirCells, OfATorusWithABoxInItsHole) {
  Walls walls = torus(1000, 300, 24);
  const std::size_t of_torus = walls.triangles.size();
  walls.add_box(-100, 100);
  const AirCells cells = cells_of(walls);
  ASSERT_EQ(cells.size(), 3U);
  for (std::size_t t = of_torus; t < walls.triangles.size(); ++t) EXPECT_EQ(cells.cell_of_side[t][0], kOpenSpace);
}

// A strip that is turned over before its ends meet has one side, and it is in open space.
TEST(AirCells, OfAMoebiusStripAreOpenSpace) {
  Walls walls;
  constexpr int kSteps = 30;
  for (int i = 0; i < kSteps; ++i) {
    const double u = 2 * std::numbers::pi * i / kSteps;
    for (const double across : {-300.0, 300.0}) {
      const double radius = 1000 + across * std::cos(u / 2);
      walls.add(std::lround(radius * std::cos(u)), std::lround(radius * std::sin(u)),
                std::lround(across * std::sin(u / 2)));
    }
  }
  for (PointId i = 0; i < kSteps; ++i) {
    const PointId a = 2 * i, b = a + 1;
    const bool last = i + 1 == kSteps;
    const PointId c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    walls.add_quad(a, b, d, c);
  }
  EXPECT_EQ(cells_of(walls).size(), 1U);
}

// Pinched at a corner, and at an edge: two cells, whatever they have in common.
TEST(AirCells, DoNotLeakThroughCornersAndEdges) {
  for (const bool at_an_edge : {false, true}) {
    Walls walls;
    walls.add_box(0, 4);
    const std::size_t first = walls.points.size();
    walls.add_box(4, 8);
    if (at_an_edge) {
      for (std::size_t i = first; i < walls.points.size(); ++i) walls.points[i].z -= 4;
    }
    std::map<LatticePoint, PointId> ids;
    for (PointId i = 0; i < walls.points.size(); ++i) ids.emplace(walls.points[i], i);
    for (Corners& t : walls.triangles) {
      for (PointId& corner : t) corner = ids.at(walls.points[corner]);
    }
    const AirCells cells = cells_of(walls);
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_TRUE(cells.volume6[1] == 6 * 64 && cells.volume6[2] == 6 * 64);
  }
}

// A small solid inside of a large one that touches one of its corners from within.
TEST(AirCells, KnowWhatTouchesFromWithin) {
  Walls walls;
  walls.add_box(0, 64);
  const PointId corner = 0, a = walls.add(20, 4, 4), b = walls.add(4, 20, 4), c = walls.add(4, 4, 20);
  const std::size_t first = walls.triangles.size();
  for (const Corners& t : {Corners{corner, b, a}, Corners{corner, a, c}, Corners{corner, c, b}, Corners{a, b, c}}) {
    walls.triangles.push_back(t);
  }
  const AirCells cells = cells_of(walls);
  ASSERT_EQ(cells.size(), 3U);
  const CellId around = cells.cell_of_side[0][1];
  for (std::size_t t = first; t < walls.triangles.size(); ++t) EXPECT_EQ(cells.cell_of_side[t][0], around);
}

TEST(AirCells, AreRefusedWhereTrianglesLieOnEachOther) {
  Walls walls;
  const PointId a = walls.add(0, 0, 0), b = walls.add(8, 0, 0), c = walls.add(0, 8, 0), d = walls.add(4, 2, 0);
  walls.triangles = {{a, b, c}, {a, b, d}};
  EXPECT_FALSE(find_air_cells(walls.points, walls.triangles).has_value());
}

TEST(AirCells, FillTheLattice) {
  Walls walls;
  constexpr std::int64_t kFar = geom::kLatticeLimit - 1;
  walls.add_box(-kFar, kFar);
  walls.add_box(-kFar + 2, kFar - 2);
  const AirCells cells = cells_of(walls);
  ASSERT_EQ(cells.size(), 3U);
  const Int128 inner = Int128{2 * kFar - 4} * (2 * kFar - 4) * (2 * kFar - 4), outer = Int128{8} * kFar * kFar * kFar;
  std::vector<Int128> volumes{cells.volume6[1], cells.volume6[2]};
  std::sort(volumes.begin(), volumes.end());
  EXPECT_TRUE(volumes[0] == 6 * (outer - inner) && volumes[1] == 6 * inner);
}

TEST(RadialOrder, IsThatOfAngles) {
  tests::LatticeRandom random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const LatticePoint from = random.point(), to = random.point();
    if (from == to) continue;
    std::vector<LatticePoint> apexes;
    while (apexes.size() < 6) {
      const LatticePoint p = random.point();
      if (!geom::collinear(from, to, p)) apexes.push_back(p);
    }
    const geom::RadialOrder order(from, to, apexes[0]);
    std::sort(apexes.begin() + 1, apexes.end(), [&](const auto& a, const auto& b) { return order.precedes(a, b); });
    // Between neighbours in the order there is no other: every one lies in the wedge from the first to the last.
    const auto turn = [&](const LatticePoint& a, const LatticePoint& b) { return geom::orient3d(from, to, a, b); };
    for (std::size_t i = 0; i + 1 < apexes.size(); ++i) {
      for (std::size_t j = i + 1; j < apexes.size(); ++j) {
        const bool less_than_half = turn(apexes[0], apexes[j]) == geom::Sign::Positive;
        EXPECT_TRUE(!less_than_half || turn(apexes[i], apexes[j]) != geom::Sign::Negative);
        EXPECT_FALSE(order.precedes(apexes[j], apexes[i]));
      }
    }
  }
}

}  // namespace
}  // namespace rad::validate
