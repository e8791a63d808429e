// What drawings need of a finding: every face that takes part, and where its violations are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "scene/scene_builder.h"
#include "tests/support/random_scenes.h"
#include "validate/lint.h"

namespace rad::validate {
namespace {

using scene::Finding;

LintResult judged(const scene::Scene& scene, bool group = true) {
  LintOptions options;
  options.group = group;
  options.tolerance = geom::ToleranceRequest{tests::kSceneTolerance, geom::ToleranceRequest::Measure::FileUnits};
  return lint(scene, {}, options);
}

void expect_drawable(const Finding& finding, std::size_t faces_of_scene) {
  const auto& ids = finding.where.face_ids;
  EXPECT_EQ(ids.size(), finding.where.face_count);
  EXPECT_TRUE(std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end()) << "ascending, each once";
  for (const scene::FaceId id : ids) EXPECT_LT(id, faces_of_scene);
  const bool placed = finding.where.point || finding.where.segment;
  EXPECT_LE(finding.where.places.size(), std::min<std::uint64_t>(finding.count, scene::kDrawnPlaces));
  if (!placed) return;
  ASSERT_FALSE(finding.where.places.empty());
  EXPECT_EQ(finding.where.places.front().point, finding.where.point) << "the worst comes first";
  EXPECT_EQ(finding.where.places.front().segment, finding.where.segment);
}

TEST(FaultPlaces, OfAnyScene_HoldAllFacesAndTheWorstPlaceFirst) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const scene::Scene scene = tests::coarse_scene(seed);
    for (const Finding& finding : judged(scene).findings) expect_drawable(finding, scene.faces.size());
  }
}

// A row of faces without area: one finding for all of them.
TEST(FaultPlaces, OfAGroup_AreThoseOfItsViolations) {
  scene::SceneBuilder builder("row.obj", "obj");
  builder.add_section({"row.obj", "", scene::RecordKind::Line});
  for (int i = 0; i < 400; ++i) {
    const double x = 4.0 * i;
    const std::array points{geom::dvec3{x, 0, 0}, geom::dvec3{x + 1, 0, 0}, geom::dvec3{x, 1e-9, 0}};
    std::vector<scene::VertexId> corners;
    for (const geom::dvec3& point : points) corners.push_back(builder.add_vertex(point));
    builder.add_face(corners, 0);
  }
  const scene::Scene scene = builder.take();
  std::uint64_t grouped = 0;
  for (const Finding& finding : judged(scene).findings) {
    if (finding.rule != "RL007") continue;
    grouped += finding.count;
    EXPECT_EQ(finding.where.places.size(), std::min<std::size_t>(finding.count, scene::kDrawnPlaces));
  }
  EXPECT_EQ(grouped, 400u);
}

}  // namespace
}  // namespace rad::validate
