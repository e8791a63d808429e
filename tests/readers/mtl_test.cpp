#include "readers/mtl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "readers/companion_path.h"
#include "readers/obj_libraries.h"
#include "tests/readers/read_text.h"
#include "tests/support/fresh_folder.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;

std::filesystem::path fixtures() { return std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/obj"; }

TEST(Mtl, ReadsReflectanceAndExitance) {
  scene::ReadIssues issues;
  const auto materials = read_mtl(
      "newmtl lamp one\nKd 0.1 0.2 0.3\r\n  Ke 5 6 7\nmap_Kd x.png\nNs 3\nnewmtl grey\nKd 0.4\n", "a.mtl", issues);
  EXPECT_TRUE(issues.all().empty());
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0].name, "lamp one");
  EXPECT_EQ(materials[0].reflectance, dvec3(0.1, 0.2, 0.3));
  EXPECT_TRUE(materials[0].reflectance_stated);
  EXPECT_EQ(materials[0].emission, dvec3(5, 6, 7));
  EXPECT_EQ(materials[0].emission_unit, scene::Material::EmissionUnit::Exitance);
  EXPECT_EQ(materials[1].reflectance, dvec3(0.4));
  EXPECT_FALSE(materials[1].emits());
}

scene::Material material_of(const std::string& statements) {
  scene::ReadIssues issues;
  const auto materials = read_mtl("newmtl a\n" + statements + "\n", "a.mtl", issues);
  EXPECT_TRUE(issues.all().empty());
  return materials.at(0);
}

TEST(Mtl, ReadsWhatADiffuseSolutionLeavesOut) {
  EXPECT_EQ(material_of("Ks 0.1 0.2 0.3").specular, dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(material_of("Ks 0.5\nillum 2").specular, dvec3(0.5));
  EXPECT_EQ(material_of("illum 1\nKs 0.5").specular, dvec3(0));
  EXPECT_EQ(material_of("d 0.25").opacity, 0.25);
  EXPECT_EQ(material_of("Tr 0.25").opacity, 0.75);
  EXPECT_EQ(material_of("Tr 0.25\nd 1").opacity, 1);
  EXPECT_EQ(material_of("Tr 1").opacity, 1);
  EXPECT_TRUE(material_of("map_d leaf.png").cut_out);
  EXPECT_TRUE(material_of("map_Ke glow.png").emission_cancelled);
  EXPECT_FALSE(material_of("map_Ke glow.png\nKe 1 1 1").emission_cancelled);
}

TEST(Mtl, PassesOverOpticsThatAreNoNumbers) {
  const scene::Material material = material_of("Ks a b c\nd -halo 0.5\nTr\nillum x");
  EXPECT_EQ(material.specular, dvec3(0));
  EXPECT_EQ(material.opacity, 1);
}

std::optional<scene::Texture> texture_of(const std::string& statement) {
  scene::ReadIssues issues;
  const auto materials = read_mtl("newmtl a\n" + statement + "\n", "a.mtl", issues);
  EXPECT_TRUE(issues.all().empty());
  return materials.at(0).texture;
}

TEST(Mtl, KeepsTheImageOfTheDiffuseColour) {
  const auto plain = texture_of("Kd 0.2 0.4 0.6\nmap_Kd my images\\oak floor.png ");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->image->path, "my images\\oak floor.png");
  EXPECT_EQ(plain->factor, (std::array{0.2, 0.4, 0.6}));
  EXPECT_FALSE(plain->transform);
  EXPECT_EQ(texture_of("map_Kd a.png\nKd 0.5")->factor, (std::array{0.5, 0.5, 0.5})) << "Kd may come later";
  EXPECT_EQ(texture_of("map_Kd a.png")->factor, (std::array{1.0, 1.0, 1.0}));
  EXPECT_FALSE(texture_of("map_Kd"));
  EXPECT_FALSE(texture_of("map_Ks a.png"));
}

TEST(Mtl, KeepsScaleOffsetAndClampingOfTheImage) {
  const auto texture = texture_of("map_Kd -blendu on -mm 0 1 -s 2 4 1 -o 0.5 0.25 -clamp on -t 1 -texres 512 a b.png");
  ASSERT_TRUE(texture && texture->transform);
  EXPECT_EQ(texture->image->path, "a b.png");
  EXPECT_EQ(texture->transform->scale, scene::dvec2(2, 4));
  EXPECT_EQ(texture->transform->offset, scene::dvec2(0.5, 1 - 4 - 0.25)) << "the origin is at the upper left there";
  EXPECT_EQ(texture->sampling.wrap_s, 33071u);
  EXPECT_EQ(texture_of("map_Kd -s 1 1 1 -o 0 0 0 a.png")->transform, std::nullopt);
  EXPECT_EQ(texture_of("map_Kd -s a.png")->image->path, "a.png");
}

TEST(Mtl, SaysWhichColoursCannotBeRead) {
  scene::ReadIssues issues;
  const auto materials = read_mtl(
      "Kd 1 1 1\nnewmtl a\nKd 1 2\nKd x 1 1\nKe nan 0 0\nKd spectral a.rfl\nKd xyz 1 1 1\nKd\n", "a.mtl", issues);
  ASSERT_EQ(materials.size(), 1u);
  EXPECT_FALSE(materials[0].reflectance_stated);
  ASSERT_EQ(issues.all().size(), 7u);
  EXPECT_EQ(issues.all()[0].what, "Kd stands before the first newmtl");
  EXPECT_EQ(issues.all()[1].place.file, "a.mtl");
  EXPECT_EQ(issues.all()[1].place.line, 3u);
  EXPECT_EQ(issues.all()[4].kind, ReadIssueKind::UnsupportedContent);
}

TEST(Mtl, RefusesBinaryBytes) {
  scene::ReadIssues issues;
  EXPECT_TRUE(read_mtl(std::string_view("newmtl a\0", 9), "a.mtl", issues).empty());
  EXPECT_EQ(issues.all().size(), 1u);
}

TEST(LibraryNames, MayHoldBlanks) {
  EXPECT_THAT(library_names("a.mtl"), ElementsAre("a.mtl"));
  EXPECT_THAT(library_names("my room.mtl b.MTL"), ElementsAre("my room.mtl", "b.MTL"));
  EXPECT_THAT(library_names("one  two\tthree"), ElementsAre("one", "two", "three"));
  EXPECT_THAT(library_names("a.mtl.old.mtl x"), ElementsAre("a.mtl.old.mtl", "x"));
  EXPECT_TRUE(library_names("").empty());
}

TEST(CompanionPath, StaysInTheFolderOfTheModel) {
  EXPECT_EQ(companion_path("models", "a.mtl"), std::filesystem::path("models/a.mtl"));
  EXPECT_EQ(companion_path("models", "sub\\b.mtl"), std::filesystem::path("models/sub/b.mtl"));
  EXPECT_EQ(companion_path("models", "./x/../a.mtl"), std::filesystem::path("models/a.mtl"));
  EXPECT_EQ(companion_path("", "a.mtl"), std::filesystem::path("./a.mtl"));
  for (const char* name : {"", "/etc/passwd", "../a.mtl", "x/../../a.mtl", "..\\a.mtl", "C:\\a.mtl", "C:a.mtl",
                           "file:a.mtl", "..", "\\a.mtl"}) {
    EXPECT_FALSE(companion_path("models", name)) << name;
  }
  EXPECT_FALSE(companion_path("models", std::string_view("a\0b", 3)));
}

TEST(CompanionPath, FollowsNoLinkOutOfTheFolder) {
  const auto base = tests::fresh_folder();
  std::filesystem::create_directories(base / "model");
  std::ofstream(base / "secret.mtl") << "newmtl a\n";
  std::filesystem::create_symlink(base / "secret.mtl", base / "model/a.mtl");
  EXPECT_FALSE(companion_path(base / "model", "a.mtl"));
  std::filesystem::remove_all(base);
}

TEST(ObjLibraries, ReadsTheLibraryBesideTheModel) {
  const ReadResult result = read_file(fixtures() / "two_libraries.obj");
  EXPECT_EQ(tests::issue_text(result), "line 11: no material library defines 'nowhere defined'\n");
  ASSERT_EQ(result.scene.materials.size(), 4u);
  EXPECT_EQ(result.scene.materials[1].name, "wall");
  EXPECT_EQ(result.scene.materials[1].reflectance, dvec3(0.7, 0.6, 0.5));
  EXPECT_EQ(result.scene.materials[2].emission, dvec3(10, 10, 10));
  EXPECT_EQ(result.scene.materials[3].name, "nowhere defined");
  EXPECT_EQ(result.scene.faces[0].material, 1u);
  EXPECT_EQ(result.scene.faces[1].material, 2u);
  EXPECT_EQ(result.scene.faces[2].material, 3u);
}

TEST(ObjLibraries, SaysWhichLibraryIsMissingOrOutside) {
  const auto result = tests::read_text("mtllib none.mtl\nmtllib ../up.mtl\nmtllib /abs.mtl\nmtllib none.mtl\nv 0 0 0\n",
                                       "model.obj", fixtures());
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::MissingResource), 3u);
  EXPECT_THAT(tests::issue_text(result), HasSubstr("line 1: material library 'none.mtl' cannot be read: "));
  EXPECT_THAT(tests::issue_text(result),
              HasSubstr("line 2: material library '../up.mtl' lies outside the model's folder"));
}

}  // namespace
}  // namespace rad::readers
