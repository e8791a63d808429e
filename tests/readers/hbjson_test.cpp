#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "readers/hbjson_subfaces.h"
#include "scene/finding.h"
#include "tests/readers/read_text.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;

std::string issues_of(const ReadResult& result) {
  std::string text;
  for (const scene::ReadIssue& issue : result.issues.all()) text += issue.place.pointer + ": " + issue.what + "\n";
  return text;
}

std::vector<dvec3> ring(const scene::Scene& scene, scene::FaceId face, std::uint32_t loop = 0) {
  std::vector<dvec3> points;
  for (const scene::VertexId id : scene.corners_of(scene.loops[scene.faces[face].first_loop + loop]))
    points.push_back(scene.vertices[id]);
  return points;
}

const std::string kTriangle = R"({"type": "Face3D", "boundary": [[0,0,0],[1,0,0],[0,1,0]]})";

ReadResult read_model(const std::string& members) {
  return tests::read_text(R"({"type": "Model", "units": "Feet", )" + members + "}", "model.hbjson");
}

class Office : public testing::Test {
 protected:
  ReadResult result_ = read_file(std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/hbjson/office.hbjson");
  const scene::Scene& scene_ = result_.scene;

  [[nodiscard]] const scene::Material& material(scene::FaceId face) const {
    return scene_.materials[scene_.faces[face].material];
  }
};

TEST_F(Office, HasUnitRoomAndNames) {
  EXPECT_EQ(tests::broken_invariant(scene_), "");
  EXPECT_EQ(scene_.metres_per_unit, 0.001);
  EXPECT_EQ(scene_.declared_tolerance, 1.0);
  EXPECT_EQ(scene_.up, scene::UpAxis::Z);
  ASSERT_EQ(scene_.faces.size(), 8u);
  EXPECT_EQ(scene_.objects[scene_.faces[0].object], "Office");
  EXPECT_EQ(scene_.groups[scene_.faces[0].group], "Floor");
  EXPECT_THAT(scene::reference_to(scene_, 3).ref,
              HasSubstr("office.hbjson#/rooms/0/faces/2/apertures/0 (Aperture Window)"));
}

TEST_F(Office, FacesOfRoomsLookIntoThem) {
  EXPECT_THAT(ring(scene_, 0), ElementsAre(dvec3(4000, 0, 0), dvec3(4000, 3000, 0), dvec3(0, 3000, 0), dvec3(0, 0, 0)));
  // The shade outside keeps its side.
  EXPECT_EQ(ring(scene_, 7)[0], dvec3(0, -2000, 0));
  EXPECT_EQ(scene_.faces[7].object, 0u);
}

TEST_F(Office, WindowsAreHolesAndDoorsNotches) {
  ASSERT_EQ(scene_.faces[2].loop_count, 2u);
  EXPECT_THAT(ring(scene_, 2, 1),
              ElementsAre(dvec3(1000, 0, 900), dvec3(3000, 0, 900), dvec3(3000, 0, 2100), dvec3(1000, 0, 2100)));
  EXPECT_EQ(scene_.faces[4].loop_count, 1u);
  EXPECT_EQ(ring(scene_, 4).size(), 8u);
  EXPECT_EQ(ring(scene_, 5).size(), 4u);
}

TEST_F(Office, ModifiersComeFromFacesAndSets) {
  EXPECT_EQ(material(1).name, "white");
  EXPECT_EQ(material(2).name, "grey");   // outdoors
  EXPECT_EQ(material(4).name, "white");  // inside
  EXPECT_NEAR(material(2).reflectance.x, 0.2, 1e-12);
  EXPECT_EQ(material(3).name, "pane");
  EXPECT_EQ(material(0).name, "Floor");
  EXPECT_FALSE(material(0).reflectance_stated);
  EXPECT_EQ(issues_of(result_),
            "/properties/radiance/modifiers/1: specular reflection of Plastic modifiers\n"
            "/properties/radiance/modifiers/2: transmission of Glass modifiers\n"
            "/rooms/0/faces/5: air boundaries, which are openings\n");
}

TEST(Hbjson, ReadsOrphansAndMeshes) {
  const ReadResult result = read_model(
      R"("orphaned_faces": [{"face_type": "Wall", "geometry": )" + kTriangle +
      R"(}], "orphaned_apertures": [{"geometry": )" + kTriangle + R"(}], "orphaned_doors": [{"geometry": )" +
      kTriangle +
      R"(}], "shade_meshes": [{"identifier": "m", "geometry": {"type": "Mesh3D", "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "faces": [[0,1,2,3],[0,1,4],[0,1,2]]}}])");
  EXPECT_EQ(result.scene.faces.size(), 5u);
  EXPECT_EQ(result.scene.metres_per_unit, 0.3048);
  EXPECT_EQ(tests::outer_loop(result.scene, 0), (std::vector<scene::VertexId>{0, 1, 2}));
  EXPECT_EQ(scene::reference_to(result.scene, 4).pointer, "/shade_meshes/0/geometry/faces/2");
  EXPECT_EQ(issues_of(result),
            "/shade_meshes/0/geometry/faces/1: vertex index 4 is outside the 4 vertices, which count from 0\n");
}

TEST(Hbjson, GlobalSetsHoldWhereRoomsHaveNone) {
  const ReadResult result = read_model(
      R"("orphaned_faces": [{"face_type": "Wall", "geometry": )" + kTriangle +
      R"(}], "properties": {"radiance": {"global_modifier_set": {"identifier": "g", "modifiers": [{"type": "Light", "identifier": "l",
         "r_emittance": 1, "g_emittance": 2, "b_emittance": 3}], "wall_set": {"exterior_modifier": "l"}}}})");
  const scene::Material& material = result.scene.materials[result.scene.faces[0].material];
  EXPECT_EQ(material.name, "l");
  EXPECT_NEAR(material.emission.z, 3 * M_PI, 1e-12);
}

TEST(Hbjson, ReportsWhatIsDamaged) {
  EXPECT_THAT(issues_of(tests::read_text(R"({"type": "Modell"})", "a.hbjson")), HasSubstr("\"type\" is not \"Model\""));
  EXPECT_THAT(issues_of(tests::read_text(R"({"type": "Model", "units": "Ells"})", "a.hbjson")),
              HasSubstr("'Ells' is not a unit"));
  const ReadResult result = read_model(
      R"("orphaned_faces": [{"face_type": "Wall"}, {"geometry": {}}, {"geometry": {"boundary": [[0,0,0],[1,"x",0],[0,1,0]]}}], "rooms": 5)");
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_TRUE(std::isnan(result.scene.vertices[1].x));
  EXPECT_EQ(issues_of(result),
            "/rooms: \"rooms\" is not an array\n/orphaned_faces/0: there is no geometry; it is left out\n"
            "/orphaned_faces/1/geometry/boundary: there is no boundary; it is left out\n"
            "/orphaned_faces/2/geometry/boundary: a point is not an array of three numbers\n");
}

std::vector<hbjson::OutlineCorner> square() {
  return {{{0, 0, 0}, {}}, {{4, 0, 0}, {}}, {{4, 0, 3}, {}}, {{0, 0, 3}, {}}};
}

TEST(Subfaces, LieInsideInNotchesOrTouch) {
  auto outline = square();
  EXPECT_EQ(hbjson::lie_of(outline, std::vector<dvec3>{{1, 0, 1}, {2, 0, 1}, {2, 0, 2}}, 0.01), hbjson::Lie::Inside);
  EXPECT_EQ(outline.size(), 4u);
  EXPECT_EQ(hbjson::lie_of(outline, std::vector<dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 2}, {0, 0, 2}}, 0.01),
            hbjson::Lie::Touching);
  EXPECT_EQ(hbjson::lie_of(outline, std::vector<dvec3>{{1, 0, 0.005}, {2, 0, 0}, {2, 0, 2}, {1, 0, 2}}, 0.01),
            hbjson::Lie::Notch);
  ASSERT_EQ(outline.size(), 8u);
  EXPECT_EQ(outline[1].at, dvec3(1, 0, 0.005));
  EXPECT_EQ(outline[2].at, dvec3(1, 0, 2));
  EXPECT_EQ(outline[4].at, dvec3(2, 0, 0));
  EXPECT_EQ(outline[5].at, dvec3(4, 0, 0));
}

TEST(Subfaces, NotchesOfPartsThatLookTheOtherWay) {
  auto outline = square();
  EXPECT_EQ(hbjson::lie_of(outline, std::vector<dvec3>{{1, 0, 2}, {2, 0, 2}, {2, 0, 0}, {1, 0, 0}}, 0.01),
            hbjson::Lie::Notch);
  EXPECT_EQ(outline[1].at, dvec3(1, 0, 0));
  EXPECT_EQ(outline[2].at, dvec3(1, 0, 2));
  EXPECT_EQ(outline[4].at, dvec3(2, 0, 0));
}

TEST(Hbjson, LivesThroughTruncationAtEveryByte) {
  const std::string text = R"({"type": "Model", "rooms": [], "orphaned_faces": [{"geometry": )" + kTriangle + "}]}";
  for (std::size_t size = 1; size < text.size(); ++size) {
    const ReadResult result = tests::read_text(std::string_view(text).substr(0, size), "a.hbjson");
    EXPECT_EQ(result.issues.all().size(), 1u) << size;
  }
}

}  // namespace
}  // namespace rad::readers
