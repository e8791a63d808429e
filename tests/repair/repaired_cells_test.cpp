// Air cells of repaired models against sight: what sees each other is in one cell, whatever repair had to cut.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geom/triangle_meeting.h"
#include "scene/repaired_scene.h"
#include "tests/support/derived_scene.h"
#include "tests/support/random_scenes.h"
#include "tests/support/repaired_checks.h"
#include "validate/air_cells.h"
#include "validate/conforming_sheets.h"

namespace rad::repair {
namespace {

using geom::LatticePoint;
using scene::dvec3;
using scene::Scene;
using Corners = std::array<LatticePoint, 3>;

LatticePoint tripled(const LatticePoint& p) { return {3 * p.x, 3 * p.y, 3 * p.z}; }

/// The sheets of a repaired scene, on the lattice three times as fine: there the middle of a triangle is a point.
struct FineSheets {
  std::vector<Corners> triangles;
  validate::AirCells cells;

  [[nodiscard]] LatticePoint middle(std::size_t i) const {
    LatticePoint sum{};
    for (const LatticePoint& p : triangles[i]) sum = {sum.x + p.x / 3, sum.y + p.y / 3, sum.z + p.z / 3};
    return sum;
  }
  /// 0 in front, 1 behind, 2 in the plane.
  [[nodiscard]] std::size_t side(std::size_t i, const LatticePoint& p) const {
    const auto sign = geom::orient3d(triangles[i][0], triangles[i][1], triangles[i][2], p);
    return sign == geom::Sign::Positive ? 0 : sign == geom::Sign::Negative ? 1 : 2;
  }
  [[nodiscard]] bool see_each_other(std::size_t i, std::size_t j) const {
    const LatticePoint from = middle(i), to = middle(j);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (k != i && k != j && geom::segment_meets_triangle(from, to, triangles[k])) return false;
    }
    return true;
  }
};

std::optional<FineSheets> fine_sheets(const Scene& scene, double tolerance) {
  const Repaired result = tests::repaired(scene, tolerance);
  if (result.model.triangles.empty()) return std::nullopt;
  const Scene written = scene::repaired_scene(result.model, scene, scene::Pieces::Triangles);
  const scene::ReadIssues none;
  std::string refusal;
  const geom::ToleranceRequest request{result.model.tolerance.length, geom::ToleranceRequest::Measure::FileUnits};
  const auto context = validate::build_context(written, none, request, refusal);
  const auto sheets = validate::conforming_sheets(*context);
  if (!sheets) return std::nullopt;
  const auto cells = validate::find_air_cells(context->model.points, sheets->triangles);
  if (!cells) return std::nullopt;
  FineSheets fine{{}, *cells};
  for (const auto& t : sheets->triangles) {
    fine.triangles.push_back({tripled(context->model.points[t[0]]), tripled(context->model.points[t[1]]),
                              tripled(context->model.points[t[2]])});
  }
  return fine;
}

// Returns how many pairs saw each other.
std::size_t expect_sight_within_cells(const FineSheets& fine, std::uint64_t seed) {
  tests::LatticeRandom random(seed);
  const auto last = static_cast<std::int64_t>(fine.triangles.size()) - 1;
  std::size_t seen = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto i = static_cast<std::size_t>(random.between(0, last)),
               j = static_cast<std::size_t>(random.between(0, last));
    if (i == j || !fine.see_each_other(i, j)) continue;
    const std::size_t of_i = fine.side(i, fine.middle(j)), of_j = fine.side(j, fine.middle(i));
    if (of_i == 2 || of_j == 2) continue;
    EXPECT_EQ(fine.cells.cell_of_side[i][of_i], fine.cells.cell_of_side[j][of_j]) << "triangles " << i << ' ' << j;
    ++seen;
  }
  return seen;
}

TEST(RepairedCells, HoldWhatSeesEachOther) {
  std::size_t seen = 0, bounded = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto fine = fine_sheets(tests::coarse_scene(seed), tests::kSceneTolerance);
    ASSERT_TRUE(fine.has_value());
    seen += expect_sight_within_cells(*fine, seed);
    bounded += fine->cells.size() - 1;
    for (validate::CellId cell = 1; cell < fine->cells.size(); ++cell) EXPECT_TRUE(fine->cells.volume6[cell] > 0);
  }
  EXPECT_GT(seen, 5000U);
  EXPECT_GT(bounded, 100U);
}

// The bottle whose cross section is an eight: it passes through itself along a circle, and its two tubes are shut off.
TEST(RepairedCells, OfAKleinBottle) {
  constexpr int kAround = 24, kAcross = 12;
  tests::SceneSketch sketch;
  const auto at = [](int i, int j) {
    const double u = 2 * std::numbers::pi * i / kAround, v = 2 * std::numbers::pi * j / kAcross;
    const double s = std::sin(v), t = std::sin(2 * v) / 2;
    const double radius = 4 + s * std::cos(u / 2) - t * std::sin(u / 2);
    return dvec3(radius * std::cos(u), radius * std::sin(u), s * std::sin(u / 2) + t * std::cos(u / 2));
  };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      sketch.face({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      sketch.face({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  const auto fine = fine_sheets(sketch.take(), 1.0 / 256);
  ASSERT_TRUE(fine.has_value());
  EXPECT_GT(expect_sight_within_cells(*fine, 1), 100U);
  EXPECT_EQ(fine->cells.size(), 2U) << "once around, each tube goes on as the other";
}

}  // namespace
}  // namespace rad::repair
