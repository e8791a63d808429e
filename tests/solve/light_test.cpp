#include "solve/light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "solve/progress.h"
#include "tests/support/grid_mesh.h"

namespace rad::solve {
namespace {

using testing::HasSubstr;
using tests::material;

TEST(Light, SoundMaterialsHaveNoProblem) {
  const std::vector<scene::Material> materials{material({0, 0.5, 0.999}, {0, 1, 1e6}), material(dvec3(0))};
  EXPECT_EQ(light_problem(materials), "");
}

TEST(Light, UnsoundMaterialsAreNamed) {
  const auto problem = [](scene::Material bad) {
    bad.name = "mirror";
    const std::vector<scene::Material> materials{material(dvec3(0.5)), bad};
    return light_problem(materials);
  };
  EXPECT_THAT(problem(material({0.5, 1.0, 0.5})), testing::AllOf(HasSubstr("'mirror'"), HasSubstr("green")));
  EXPECT_THAT(problem(material({0.5, 0.5, -0.1})), HasSubstr("blue reflectance"));
  EXPECT_THAT(problem(material({std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5})), HasSubstr("red reflectance"));
  EXPECT_THAT(problem(material(dvec3(0.5), {0, -1, 0})), HasSubstr("green emission"));
  EXPECT_THAT(problem(material(dvec3(0.5), {0, 0, std::numeric_limits<double>::infinity()})),
              HasSubstr("blue emission"));
}

TEST(Light, ExitanceOfALuminanceIsPiTimesIt) {
  scene::Material light = material(dvec3(0), {1, 2, 3});
  EXPECT_EQ(exitance(light), dvec3(1, 2, 3));
  light.emission_unit = scene::Material::EmissionUnit::Luminance;
  EXPECT_NEAR(exitance(light).z, 3 * std::numbers::pi, 1e-12);
}

TEST(Light, EmittersAreLookedForOnPatches) {
  tests::GridMesh grid(2);
  grid.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1, 1, 0);
  const std::vector<scene::Material> materials{material(dvec3(0.5)), material(dvec3(0.5), {0, 0, 1})};
  EXPECT_FALSE(has_emitters(grid.mesh, materials));
  grid.add_rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 1, 1, 1, 1);
  EXPECT_TRUE(has_emitters(grid.mesh, materials));
}

TEST(ProgressCalls, AreFew) {
  int calls = 0;
  Progress progress([&](const ProgressState&) {
    ++calls;
    return true;
  });
  for (int i = 0; i < 100000; ++i) EXPECT_TRUE(progress.go_on(0.5, 1));
  EXPECT_GE(calls, 1);
  EXPECT_LT(calls, 1000);
}

TEST(ProgressCalls, OnceStoppedItStaysStopped) {
  Progress progress([](const ProgressState&) { return false; });
  EXPECT_FALSE(progress.go_on(0.5, 1));
  EXPECT_FALSE(progress.go_on(0.5, 1));
}

}  // namespace
}  // namespace rad::solve
