#include <gtest/gtest.h>

#include "report/html/view_record.h"
#include "tests/bake/drawn_scenes.h"
#include "tests/report/sample_reports.h"

namespace rad::report::html {
namespace {

ModelView sample_view() {
  InputReport input = samples::clean_input();
  scene::Finding placed = samples::t_vertex(3, 1.0 / 3), elsewhere;
  placed.where.face_ids = {1, 4};
  placed.where.places = {{placed.where.point, placed.where.segment}};
  elsewhere.rule = "RL006";
  input.result.findings = {placed, elsewhere};
  return model_view(tests::box_scene(tests::Facing::Outward), input, 100).value();
}

TEST(ViewRecord, ComesBackToTheLastBit) {
  const ModelView view = sample_view();
  const std::string record = view_record(view);
  const auto back = view_of_record(record);
  ASSERT_TRUE(back);
  EXPECT_EQ(view_record(*back), record);
  EXPECT_EQ(back->geometry.bytes, view.geometry.bytes);
  EXPECT_EQ(back->camera.position, view.camera.position);
  EXPECT_EQ(back->overview.png, view.overview.png);
  ASSERT_EQ(back->faults.size(), 2u);
  EXPECT_EQ(back->faults[0].triangles, view.faults[0].triangles);
  EXPECT_TRUE(back->faults[0].camera);
  EXPECT_FALSE(back->faults[1].camera);
}

TEST(ViewRecord, OfOtherBytes_IsNothing) {
  const std::string record = view_record(sample_view());
  EXPECT_FALSE(view_of_record(""));
  EXPECT_FALSE(view_of_record("{}"));
  EXPECT_FALSE(view_of_record(std::string(100, '\xff')));
  EXPECT_FALSE(view_of_record(std::string_view(record).substr(0, record.size() / 2)));
}

}  // namespace
}  // namespace rad::report::html
