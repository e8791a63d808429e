// What OBJ gives to corners and faces beside positions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/readers/read_text.h"
#include "tests/support/corner_values_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec2;
using scene::dvec3;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::normals_of;
using tests::texture_of;

ReadResult read_obj(const std::string& faces) {
  return tests::read_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0.1 0.2\nvt 0.3\nvt 5 6 7\nvn 0 0 1\nvn 0 1 0\n" + faces, "model.obj");
}

TEST(ObjAttributes, AreThoseOfTheCorner) {
  const scene::Scene scene = read_obj("f 1/1 2/2 3/3\nf 1//1 2//2 3//1\nf 1/3/2 2/-2/-1 3/1/-2\nf 1 2 3\n").scene;
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_THAT(texture_of(scene, 0), ElementsAre(dvec2(0.1, 0.2), dvec2(0.3, 0), dvec2(5, 6)));
  EXPECT_THAT(normals_of(scene, 0), IsEmpty());
  EXPECT_THAT(texture_of(scene, 1), IsEmpty());
  EXPECT_THAT(normals_of(scene, 1), ElementsAre(dvec3(0, 0, 1), dvec3(0, 1, 0), dvec3(0, 0, 1)));
  EXPECT_THAT(texture_of(scene, 2), ElementsAre(dvec2(5, 6), dvec2(0.3, 0), dvec2(0.1, 0.2)));
  EXPECT_THAT(normals_of(scene, 2), ElementsAre(dvec3(0, 1, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)));
  EXPECT_THAT(texture_of(scene, 3), IsEmpty());
  EXPECT_EQ(scene.attributes.texture_origin, scene::TextureOrigin::LowerLeft);
}

TEST(ObjAttributes, ThatTheFileDoesNotHoldAtAllAreNoIssue) {
  const ReadResult result = tests::read_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/2/2 3/3/3\n", "a.obj");
  EXPECT_TRUE(result.scene.attributes.empty());
  EXPECT_EQ(tests::issue_text(result), "");
}

TEST(ObjAttributes, CostNothingWhereThereAreNone) {
  const scene::Scene scene = read_obj("f 1 2 3\nf 2 4 3\n").scene;
  EXPECT_TRUE(scene.attributes.empty());
  EXPECT_TRUE(scene.attributes.texture_coordinates.table.empty()) << "vt that no face names";
  EXPECT_TRUE(scene.smoothing_groups.empty());
}

TEST(ObjAttributes, MayFollowTheFacesThatNameThem) {
  const scene::Scene scene =
      tests::read_text("f 1/1 2/2 3/1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 2\nvt 3 4\nf 1/2 2/2 3/1\n", "a.obj").scene;
  EXPECT_EQ(tests::broken_invariant(scene), "");
  EXPECT_THAT(texture_of(scene, 0), ElementsAre(dvec2(1, 2), dvec2(3, 4), dvec2(1, 2)));
  EXPECT_THAT(texture_of(scene, 1), ElementsAre(dvec2(3, 4), dvec2(3, 4), dvec2(1, 2)));
}

TEST(ObjAttributes, OfAFaceAreAllOrNone) {
  for (const char* face : {"f 1/1 2 3/1\n", "f 1/1 2/9 3/1\n", "f 1/1 2/-9 3/1\n", "f 1/1 2/0 3/1\n",
                           "f 1/1 2/99999999999999999999 3/1\n", "f 1/1 2/1- 3/1\n"}) {
    SCOPED_TRACE(face);
    const ReadResult result = read_obj(std::string(face) + "f 1/1 2/1 3/1\n");
    ASSERT_EQ(result.scene.faces.size(), 2u) << "the face itself stays";
    EXPECT_EQ(tests::broken_invariant(result.scene), "");
    EXPECT_THAT(texture_of(result.scene, 0), IsEmpty());
    EXPECT_EQ(texture_of(result.scene, 1).size(), 3u);
    EXPECT_EQ(tests::issue_count(result, scene::ReadIssueKind::UnsupportedContent), 1u);
    EXPECT_EQ(result.issues.all().size(), 1u);
  }
}

TEST(ObjAttributes, ThatAreNoNumbersAreNone) {
  const ReadResult result = tests::read_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt x 1\nvt nan 1\nvt 1 inf\nvt 1 1\nvn 1 0\nf 1/1 2/4 3/4\nf 1/2 2/4 3/4\n"
      "f 1/3 2/4 3/4\nf 1//1 2//1 3//1\nf 1/4 2/4 3/4\n",
      "a.obj");
  EXPECT_EQ(tests::broken_invariant(result.scene), "");
  ASSERT_EQ(result.scene.faces.size(), 5u);
  for (scene::FaceId face = 0; face < 4; ++face) EXPECT_THAT(texture_of(result.scene, face), IsEmpty());
  EXPECT_EQ(texture_of(result.scene, 4).size(), 3u);
  ASSERT_EQ(result.issues.all().size(), 1u);
  EXPECT_EQ(result.issues.all()[0].count, 4u);
}

TEST(ObjAttributes, KeepSmoothingGroups) {
  const scene::Scene scene = read_obj("f 1 2 3\ns 2\nf 2 4 3\nf 1 2 4\ns off\nf 1 3 4\ns x\nf 1 3 4\n").scene;
  EXPECT_THAT(scene.smoothing_groups, ElementsAre(0, 2, 2, 0, 0));
}

TEST(ObjAttributes, KeepSmoothingGroupsOfFacesThatWait) {
  const scene::Scene scene = tests::read_text("s 3\nf 1 2 3\ns 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj").scene;
  EXPECT_THAT(scene.smoothing_groups, ElementsAre(3, 0));
}

}  // namespace
}  // namespace rad::readers
