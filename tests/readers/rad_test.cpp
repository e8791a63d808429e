#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "readers/rad_shapes.h"
#include "readers/rad_words.h"
#include "readers/rad_xform.h"
#include "scene/finding.h"
#include "tests/readers/read_text.h"
#include "tests/support/fresh_folder.h"
#include "tests/support/scene_invariants.h"

namespace rad::readers {
namespace {

using scene::dvec3;
using scene::ReadIssueKind;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::issue_text;

ReadResult read_rad(std::string_view text) { return tests::read_text(text, "model.rad"); }

const scene::Material& material_of(const scene::Scene& scene, scene::FaceId face) {
  return scene.materials[scene.faces[face].material];
}

constexpr std::string_view kTriangle = "polygon wall.3 0 0 9 0 0 0 1 0 0 0 1 0\n";

/// Six times the volume that the faces of a shape enclose, positive where they look outwards.
double six_volumes(const radiance::Shape& shape) {
  double sum = 0;
  for (const auto& ring : shape.faces) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      sum += glm::dot(shape.points[ring[0]], glm::cross(shape.points[ring[i]], shape.points[ring[i + 1]]));
    }
  }
  return sum;
}

radiance::Shape shape_of(std::string_view type, std::vector<double> reals) {
  std::string problem;
  radiance::Shape shape = radiance::shape_of(type, reals, problem);
  EXPECT_EQ(problem, "");
  return shape;
}

TEST(Rad, ReadsPolygonsWithIdentifierAndMaterial) {
  const ReadResult result = read_rad("# comment\nvoid plastic red 0 0 5 .7 .2 .1 .1 .05\nred\n" +
                                     std::string(kTriangle) + "void " + std::string(kTriangle));
  ASSERT_EQ(result.scene.faces.size(), 2u);
  EXPECT_EQ(issue_text(result), "line 2: specular reflection of plastic materials\n");
  EXPECT_EQ(material_of(result.scene, 0).name, "red");
  EXPECT_NEAR(material_of(result.scene, 0).reflectance.x, 0.63, 1e-12);
  EXPECT_EQ(result.scene.faces[1].material, 0u);
  EXPECT_EQ(result.scene.objects[result.scene.faces[0].object], "wall");
  EXPECT_EQ(scene::reference_to(result.scene, 0).ref, "model.rad:3 (polygon wall.3)");
  EXPECT_EQ(result.scene.metres_per_unit, std::nullopt);
}

TEST(Rad, MaterialsBecomeReflectanceAndExitance) {
  const ReadResult result = read_rad(
      "void trans t 0 0 7 .5 .5 .5 0 0 .4 .5\nvoid glass g 0 0 3 .9 .9 .9\nvoid light l 0 0 3 10 20 30\n"
      "void BRTDfunc f 10 0 0 0 0 0 0 0 0 0 . 0 9 1 1 1 1 1 1 1 1 1\n"
      "t polygon a 0 0 9 0 0 0 1 0 0 0 1 0 g polygon b 0 0 9 0 0 0 1 0 0 0 1 0 l polygon c 0 0 9 0 0 0 1 0 0 0 1 0 "
      "f polygon d 0 0 9 0 0 0 1 0 0 0 1 0");
  const auto& scene = result.scene;
  ASSERT_EQ(scene.faces.size(), 4u);
  EXPECT_NEAR(material_of(scene, 0).reflectance.x, 0.3, 1e-12);
  EXPECT_EQ(material_of(scene, 1).reflectance, dvec3(0, 0, 0));
  EXPECT_TRUE(material_of(scene, 1).reflectance_stated);
  EXPECT_NEAR(material_of(scene, 2).emission.y, 20 * std::numbers::pi, 1e-12);
  EXPECT_EQ(material_of(scene, 2).emission_unit, scene::Material::EmissionUnit::Exitance);
  EXPECT_FALSE(material_of(scene, 3).reflectance_stated);
  EXPECT_THAT(issue_text(result), HasSubstr("transmission of glass materials"));
  EXPECT_THAT(issue_text(result), HasSubstr("scattering by data or functions of BRTDfunc materials"));
}

TEST(Rad, AliasesAndRedefinitionsHoldFromWhereTheyStand) {
  const ReadResult result = read_rad(
      "void plastic a 0 0 5 .1 .1 .1 0 0\nvoid alias b a\nb polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n"
      "void plastic a 0 0 5 .2 .2 .2 0 0\na polygon q 0 0 9 0 0 0 1 0 0 0 1 0\n\"no such\" polygon r 0 0 9 0 0 0 1 0 0 "
      "0 1 0\n");
  ASSERT_EQ(result.scene.faces.size(), 3u);
  EXPECT_EQ(material_of(result.scene, 0).reflectance.x, 0.1);
  EXPECT_EQ(material_of(result.scene, 1).reflectance.x, 0.2);
  EXPECT_EQ(material_of(result.scene, 1).name, "a (2)");
  EXPECT_EQ(issue_text(result), "line 6: the modifier 'no such' is not defined\n");
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::MissingResource), 1u);
}

TEST(Rad, PatternsSourcesAndAntimatterAreCounted) {
  const ReadResult result = read_rad(
      "void brightfunc stripes 2 s f.cal 0 0\nstripes plastic p 0 0 5 .5 .5 .5 0 0\n"
      "p source sun 0 0 4 0 0 1 .5\nvoid mesh m 1 m.rtm 0 0\nvoid antimatter hole 1 p 0 0\n"
      "hole sphere ball 0 0 4 0 0 0 1\nstripes polygon bare 0 0 9 0 0 0 1 0 0 0 1 0\n");
  EXPECT_EQ(result.scene.faces.size(), 1u);
  EXPECT_FALSE(material_of(result.scene, 0).reflectance_stated);
  EXPECT_EQ(issue_text(result),
            "line 1: brightfunc patterns and textures\nline 3: source primitives (distant light)\n"
            "line 4: mesh primitives (compiled files)\nline 6: surfaces of antimatter, and what they cut away\n");
}

TEST(Rad, ShapesLookOutwardsOrInwards) {
  const double outwards = six_volumes(shape_of("sphere", {1, 2, 3, 2}));
  EXPECT_GT(outwards, 0.9 * 8 * std::numbers::pi * 4);
  EXPECT_NEAR(six_volumes(shape_of("bubble", {1, 2, 3, 2})), -outwards, 1e-9);
  EXPECT_NEAR(six_volumes(shape_of("sphere", {1, 2, 3, -2})), -outwards, 1e-9);
  // Open at the ends: volumes are counted from the lower centre.
  EXPECT_GT(six_volumes(shape_of("cylinder", {0, 0, 0, 1, 1, 1, 0.5})), 0);
  EXPECT_LT(six_volumes(shape_of("tube", {0, 0, 0, 1, 1, 1, 0.5})), 0);
  EXPECT_GT(six_volumes(shape_of("cone", {0, 0, 0, 0, 0, 1, 0.5, 0})), 0);
  EXPECT_LT(six_volumes(shape_of("cup", {0, 0, 0, 0, 0, 1, 0.5, 0.2})), 0);
}

TEST(Rad, ShapesHaveTheFacesThatTheyNeed) {
  EXPECT_EQ(shape_of("sphere", {0, 0, 0, 1}).faces.size(), 24u * 12);
  EXPECT_EQ(shape_of("cylinder", {0, 0, 0, 0, 0, 1, 1}).faces.size(), 24u);
  EXPECT_EQ(shape_of("cone", {0, 0, 0, 0, 0, 1, 0, 1}).faces[0].size(), 3u);
  const radiance::Shape disc = shape_of("ring", {0, 0, 0, 0, 0, 1, 1, 0});
  EXPECT_EQ(disc.faces.size(), 1u);
  EXPECT_TRUE(disc.holes.empty());
  EXPECT_EQ(shape_of("ring", {0, 0, 0, 0, 0, 1, 1, 0.5}).holes.size(), 1u);
  EXPECT_EQ(shape_of("polygon", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0}).faces[0].size(), 3u);
}

TEST(Rad, ShapesWithoutSizeAreRefused) {
  const ReadResult result = read_rad(
      "void sphere a 0 0 4 0 0 0 0\nvoid sphere b 0 0 3 0 0 0\nvoid cylinder c 0 0 7 1 1 1 1 1 1 2\n"
      "void ring d 0 0 8 0 0 0 0 0 0 0 1\nvoid polygon e 0 0 8 0 0 0 1 1 1 2 2\nvoid " +
      std::string(kTriangle));
  EXPECT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(tests::issue_count(result, ReadIssueKind::ParseError), 5u);
  EXPECT_THAT(issue_text(result), HasSubstr("line 1: a sphere has the radius 0 ('a'); it is left out"));
}

TEST(Rad, DamageEndsTheFileWithItsLine) {
  EXPECT_EQ(issue_text(read_rad("void polygon a 0 0 9 0.25 0.25 0.25\n1 0 0")),
            "line 2: the file ends within the arguments of 'a'\n");
  EXPECT_THAT(issue_text(read_rad("void polygon a 0 0 999999999999 1")), HasSubstr("do not begin with their number"));
  EXPECT_THAT(issue_text(read_rad("void plastik a 0 0 0\nvoid polygon a 0 0 0")),
              HasSubstr("'plastik' is not a type of primitive"));
  const ReadResult bad = read_rad("void polygon a 0 0 9 0 x 0 1 0 0 0 1 0");
  EXPECT_EQ(issue_text(bad), "line 1: 'x' is not a number\n");
  EXPECT_TRUE(std::isnan(bad.scene.vertices[0].y));
}

TEST(Rad, CommandsAreNotRun) {
  const ReadResult result =
      read_rad("!genbox a b 1 1 1\n!xform x.rad | cat\n!xform ../up.rad\n!xform no.rad\n!xform -q x\nvoid " +
               std::string(kTriangle));
  EXPECT_EQ(result.scene.faces.size(), 1u);
  const std::string issues = issue_text(result);
  EXPECT_THAT(issues, testing::StartsWith("line 1: commands (genbox), which are not run\n"
                                          "line 2: commands (xform), which are not run\n"
                                          "line 3: the file '../up.rad' lies outside the model's folder and is not "
                                          "opened\nline 4: the file 'no.rad' cannot be read: "));
  EXPECT_THAT(issues, testing::EndsWith("line 5: xform has the argument '-q', which is not followed; what it places is "
                                        "left out\n"));
}

std::vector<dvec3> origins(std::vector<std::string> words) {
  const radiance::Xform xform = radiance::parse_xform(words, 1000);
  EXPECT_EQ(xform.problem, "");
  std::vector<dvec3> points;
  for (const auto& copy : xform.copies) {
    const glm::dvec4 p = copy.matrix * glm::dvec4(0, 0, 0, 1);
    points.emplace_back(std::round(p.x * 1e9) / 1e9 + 0.0, std::round(p.y * 1e9) / 1e9 + 0.0,
                        std::round(p.z * 1e9) / 1e9 + 0.0);
  }
  return points;
}

TEST(Xform, AppliesTransformationsInTheOrderGiven) {
  EXPECT_THAT(origins({"-t", "1", "0", "0", "-rz", "90", "-s", "2"}), ElementsAre(dvec3(0, 2, 0)));
  EXPECT_THAT(origins({"-rz", "90", "-t", "1", "0", "0", "-mx"}), ElementsAre(dvec3(-1, 0, 0)));
}

TEST(Xform, ArraysRepeatWhatFollowsThem) {
  EXPECT_THAT(origins({"-t", "0",  "0", "1", "-a", "2",  "-t", "3",  "0", "0", "-a",
                       "2",  "-t", "0", "5", "0",  "-i", "1",  "-t", "0", "0", "1"}),
              ElementsAre(dvec3(0, 0, 2), dvec3(0, 5, 2), dvec3(3, 0, 2), dvec3(3, 5, 2)));
  EXPECT_THAT(origins({"-i", "3", "-t", "1", "0", "0"}), ElementsAre(dvec3(3, 0, 0)));
}

TEST(Xform, NamesCopies) {
  const std::vector<std::string> unnamed = {"-a", "2", "-t", "1", "0", "0", "-a", "2", "-t", "0", "1", "0", "f.rad"};
  const radiance::Xform xform = radiance::parse_xform(unnamed, 10);
  EXPECT_EQ(xform.copies[3].prefix, "a1.1.");
  EXPECT_THAT(xform.files, ElementsAre("f.rad"));
  const std::vector<std::string> named = {"-n", "x", "-m", "paint", "-I", "-a", "2", "-t", "1", "0", "0"};
  EXPECT_EQ(radiance::parse_xform(named, 10).copies[1].prefix, "x.1.");
  EXPECT_EQ(radiance::parse_xform(named, 10).modifier, "paint");
  EXPECT_TRUE(radiance::parse_xform(named, 10).inverted);
}

TEST(Xform, RefusesCountsBeyondTheLimit) {
  const std::vector<std::string> words = {"-a", "11", "-t", "1", "0", "0"};
  EXPECT_THAT(radiance::parse_xform(words, 10).problem, HasSubstr("beyond the limit of 10"));
  const std::vector<std::string> product = {"-a", "9", "-t", "1", "0", "0", "-a", "9", "-t", "1", "0", "0"};
  EXPECT_THAT(radiance::parse_xform(product, 10).problem, HasSubstr("more copies than the limit"));
}

TEST(Words, KnowsQuotesCommentsAndCommands) {
  radiance::Words words("'a b' # c\n\"d\"e !f\n!g \\\nh\ni");
  EXPECT_EQ(words.next(), "a b");
  EXPECT_EQ(words.next(), "d");
  EXPECT_EQ(words.line(), 2u);
  EXPECT_EQ(words.next(), "e");
  EXPECT_TRUE(words.at_command());
  EXPECT_EQ(words.command(), "f");
  EXPECT_TRUE(words.at_command());
  EXPECT_EQ(words.command(), "g  h");
  EXPECT_EQ(words.next(), "i");
  EXPECT_EQ(words.line(), 5u);
  EXPECT_TRUE(words.at_end());
}

TEST(Rad, PlacesFilesBelowTheModelsFolder) {
  const auto path = std::filesystem::path(RAD_SOURCE_DIR) / "corpus/formats/rad/room.rad";
  const ReadResult result = read_file(path);
  EXPECT_EQ(issue_text(result), "line 8: specular reflection of plastic materials\n");
  EXPECT_EQ(result.scene.format, "rad");
  ASSERT_EQ(result.scene.faces.size(), 6u + 288 + 2 * 25);
  const auto last = static_cast<scene::FaceId>(result.scene.faces.size() - 1);
  EXPECT_EQ(material_of(result.scene, last).name, "oak");
  EXPECT_EQ(result.scene.objects[result.scene.faces[last].object], "stools.1.seat");
  const std::string place = scene::reference_to(result.scene, last).ref;
  EXPECT_THAT(place, HasSubstr("objects/stool.rad:3 (ring stools.1.seat.1)"));
}

TEST(Rad, CommandsAreRunWhereTheUserAllowsIt) {
  Input input{"model.rad", ".", "!echo void polygon a.1 0 0 9 0 0 0 1 0 0 0 1 0\n!exit 1\n", {}, {}};
  input.choices.allow_commands = true;
  const ReadResult result = read_bytes(input);
  ASSERT_EQ(result.scene.faces.size(), 1u);
  EXPECT_EQ(result.scene.faces[0].source.record, 1u);
  EXPECT_EQ(issue_text(result), "line 2: the command 'exit 1' gives nothing\n");
}

TEST(Rad, MaterialsThatAreDefinedTwiceAlikeAreOne) {
  const std::string paint = "void plastic paint 0 0 5 .5 .5 .5 0 0\npaint " + std::string(kTriangle);
  const ReadResult result = read_rad(paint + paint);
  EXPECT_EQ(result.scene.materials.size(), 2u);
}

TEST(Rad, FilesThatPlaceThemselvesStop) {
  const auto folder = tests::fresh_folder();
  std::ofstream(folder / "a.rad") << "void " << kTriangle << "!xform -t 1 0 0 a.rad\n!xform -t 0 1 0 a.rad\n";
  Limits limits;
  limits.instances = 500;
  const ReadResult result = read_file(folder / "a.rad", limits);
  EXPECT_THAT(issue_text(result), HasSubstr("more than 32 deep"));
  EXPECT_LE(result.scene.faces.size(), 501u);
  std::filesystem::remove_all(folder);
}

TEST(Rad, IsKnownByItsContent) {
  EXPECT_EQ(tests::read_text("void plastic a 0 0 5 .5 .5 .5 0 0\n", "scene.txt").scene.format, "rad");
  EXPECT_EQ(tests::read_text("!xform a.rad\n", "scene.txt").scene.format, "rad");
}

TEST(Rad, LivesThroughTruncationAtEveryByte) {
  const std::string text =
      "void plastic a 0 0 5 .5 .5 .5 0 0\n!xform a.rad\na sphere b 0 0 4 0 0 0 1\na ring c 0 0 8 0 0 0 0 0 1 1 2\n";
  for (std::size_t size = 1; size < text.size(); ++size) {
    EXPECT_EQ(tests::broken_invariant(read_rad(std::string_view(text).substr(0, size)).scene), "") << size;
  }
}

}  // namespace
}  // namespace rad::readers
