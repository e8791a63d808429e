#include "cli/convert.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/radfix.h"
#include "tests/cli/fix_models.h"
#include "tests/cli/run.h"

namespace rad::cli {
namespace {

using testing::HasSubstr;

class Convert : public InFolder {
 protected:
  static Outcome convert(std::vector<std::string> args) {
    args.insert(args.begin(), "convert");
    return outcome_of(run_radfix, args);
  }
};

TEST_F(Convert, WritesTheSameFacesAndSaysWhatIsLost) {
  const std::string model = write("lit.obj", kLitScene);
  write("lit.mtl", kLitMaterials);
  const Outcome there = convert({model, at("lit.rad")});
  EXPECT_EQ(there.exit_code, 0);
  EXPECT_THAT(there.out, HasSubstr("lit.rad: 8 faces, 8 written as Radiance\n  lost: 1 reflectance of a light\n"));
  const Outcome back = convert({at("lit.rad"), at("back.obj")});
  EXPECT_EQ(back.exit_code, 0);
  EXPECT_THAT(read("back.obj"), HasSubstr("o ground\nusemtl white\nf 1 2 3 4\n"));
  EXPECT_THAT(read("back.mtl"), HasSubstr("newmtl white\nKd 0.5 0.5 0.5\n"));
}

TEST_F(Convert, KeepsPolygonsThroughEveryFormatThatHasThem) {
  const std::string model = write("box.obj", kBox);
  for (const std::string format : {"rad", "city.json", "off", "ply", "dxf"}) {
    ASSERT_EQ(convert({model, at("box." + format)}).exit_code, 0) << format;
    ASSERT_EQ(convert({at("box." + format), at("back.off")}).exit_code, 0) << format;
    const std::string text = read("back.off");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n') > 0, true);
    std::size_t quads = 0;
    for (std::size_t line = text.find("\n4 "); line != std::string::npos; line = text.find("\n4 ", line + 1)) ++quads;
    EXPECT_EQ(quads, 6u) << format;
  }
}

TEST_F(Convert, DividesFacesForFormatsOfTriangles) {
  const std::string model =
      write("l.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\nf 1 1 1\n");
  const Outcome outcome = convert({model, at("l.stl")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("2 faces, 5 written as STL"));
  EXPECT_THAT(outcome.out, HasSubstr("lost: 1 face is divided into triangles"));
}

TEST_F(Convert, ListsFormats) {
  const Outcome outcome = convert({"--list"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("CityJSON    polygons"));
  EXPECT_THAT(outcome.out, HasSubstr("\nRead: "));
  EXPECT_THAT(outcome.out, HasSubstr(" .dxf"));
}

TEST_F(Convert, SaysWhatTheReaderLeftOutAndWhy) {
  const std::string model = write("a.rad", "!genbox a b 1 1 1\nvoid polygon p 0 0 9 0 0 0 1 0 0 0 1 0\n");
  EXPECT_THAT(convert({model, at("a.obj")}).err, HasSubstr("a.rad:1: commands (genbox), which are not run"));
}

TEST_F(Convert, RefusesWhatCannotBe) {
  const std::string model = write("box.obj", kBox);
  EXPECT_EQ(convert({}).exit_code, 2);
  EXPECT_EQ(convert({model}).exit_code, 2);
  EXPECT_THAT(convert({model, model}).err, HasSubstr("is the input"));
  EXPECT_THAT(convert({at("no.obj"), at("a.obj")}).err, HasSubstr("no such file"));
  EXPECT_THAT(convert({model, at("a.dwg")}).err, HasSubstr("not a format that convert writes"));
  EXPECT_EQ(convert({write("points.obj", "v 0 0 0\n"), at("a.stl")}).exit_code, 4);
  EXPECT_EQ(convert({write("bad.ply", "ply\nx"), at("a.stl")}).exit_code, 2);
}

}  // namespace
}  // namespace rad::cli
