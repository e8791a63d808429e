// The reference solutions, on uniform grids: the folder is found through RAD_SHARED.
#include <gtest/gtest.h>

#include <cstdlib>

#include "solve/solver.h"
#include "tests/solve/reference_case.h"

namespace rad::solve {
namespace {

struct GivenCase {
  const char* name;
  double patch_size;  ///< m
  int split;          ///< elements along the edge of a patch
  double unshot_limit;
};

void PrintTo(const GivenCase& given, std::ostream* out) { *out << given.name; }

class Reference : public testing::TestWithParam<GivenCase> {};

TEST_P(Reference, IsMetWithinItsTolerances) {
  const char* const shared = std::getenv("RAD_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "RAD_SHARED names no folder";
  const GivenCase& given = GetParam();
  const auto reference = tests::read_case(std::filesystem::path(shared) / "reference" / "cases" / given.name);
  const mesh::RadiosityMesh mesh = tests::grid_of(reference, given.patch_size, given.split);
  SolveOptions options;
  options.unshot_limit = given.unshot_limit;
  Progress progress;
  const mesh::RadiosityField field = solve(mesh, reference.scene.materials, options, progress);
  const tests::Score score = tests::score_of(reference, mesh, field);
  EXPECT_GE(score.probes, 5u);
  EXPECT_EQ(score.missing, 0u);
  EXPECT_LE(score.mean, reference.tolerance.mean);
  EXPECT_LE(score.p95, reference.tolerance.p95);
  EXPECT_LE(score.largest, reference.tolerance.largest);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Reference,
    testing::Values(GivenCase{"bleed_corner", 0.25, 4, 1e-3}, GivenCase{"cie171_5_3_floor", 0.5, 4, 1e-3},
                    GivenCase{"cie171_5_6_wall", 0.5, 4, 1e-3}, GivenCase{"cie171_5_7_floor", 0.5, 4, 1e-3},
                    GivenCase{"cube_room", 0.25, 3, 1e-3}, GivenCase{"furnace_cube", 0.5, 2, 1e-3},
                    GivenCase{"light_rect_h2", 0.5, 4, 1e-3}, GivenCase{"light_rect_near005", 0.2, 8, 1e-3},
                    GivenCase{"long_room_90", 0.25, 2, 1e-4}, GivenCase{"parallel_squares_d02", 0.25, 4, 1e-3},
                    GivenCase{"penumbra_square", 0.5, 4, 1e-3}, GivenCase{"perpendicular_squares", 0.125, 8, 1e-3},
                    GivenCase{"sphere_cavity", 0.25, 1, 1e-3}),
    [](const testing::TestParamInfo<GivenCase>& given) { return given.param.name; });

}  // namespace
}  // namespace rad::solve
