// Curves, false colours and the page of a solution.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/radfix.h"
#include "fix_models.h"
#include "readers/reader.h"
#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class DisplayOptions : public InFolder {
 protected:
  [[nodiscard]] Outcome solve(const std::vector<std::string>& more, const std::string& output = "lit.gltf") const {
    write("lit.mtl", kLitMaterials);
    std::vector<std::string> args{write("lit.obj", kLitScene), "-o", at(output), "--solve", "--patch-size", "1"};
    args.insert(args.end(), more.begin(), more.end());
    return outcome_of(&run_radfix, args);
  }
  [[nodiscard]] json record() const { return json::parse(read("lit.gltf"))["asset"]["extras"]["radfix"]; }
};

TEST_F(DisplayOptions, CurvesAreRecorded) {
  for (const char* curve : {"linear", "shoulder", "reinhard"}) {
    ASSERT_EQ(solve({"--curve", curve}).exit_code, 0);
    EXPECT_EQ(record()["curve"], curve);
    EXPECT_FALSE(record().contains("scale"));
  }
}

TEST_F(DisplayOptions, AShoulderCutsNothingOff) {
  ASSERT_EQ(solve({"--curve", "shoulder"}).exit_code, 0);
  EXPECT_EQ(record()["clampedShare"], 0);
}

TEST_F(DisplayOptions, FalseColoursHaveAScale_UpToARoundNumber) {
  ASSERT_EQ(solve({"--falsecolor", "--preview", at("lit.png")}).exit_code, 0);
  EXPECT_EQ(record()["curve"], "falsecolor");
  const json scale = record()["scale"];
  ASSERT_EQ(scale.size(), 10u);
  EXPECT_EQ(scale[0]["radiosity"], 0);
  const double most = scale[9]["radiosity"];
  EXPECT_NEAR(most, 1 / record()["exposure"].get<double>(), 1e-9 * most);
  const double digit = most / std::pow(10, std::floor(std::log10(most) + 1e-9));
  EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9) << most;
  EXPECT_FALSE(read("lit.png").empty());
}

TEST_F(DisplayOptions, HoldForLightMaps_ButNotForEmissiveOnes) {
  ASSERT_EQ(solve({"--falsecolor", "--bake", "lightmap"}).exit_code, 0);
  EXPECT_EQ(json::parse(read("lit.atlas.json"))["curve"], "falsecolor");
  const Outcome outcome = solve({"--curve", "reinhard", "--bake", "emissive"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no curve"));
}

TEST_F(DisplayOptions, ACameraCanBeNamed) {
  ASSERT_EQ(solve({"--preview", at("chosen.png")}).exit_code, 0);
  ASSERT_EQ(solve({"--preview", at("named.png"), "--camera", "8,-6,5:2,2,0.5"}).exit_code, 0);
  EXPECT_NE(read("named.png"), read("chosen.png"));
  for (const char* camera : {"1,2,3", "1,2:3,4,5", "1,2,3:1,2,3", "1,2,3:4,5,6,7", "a,b,c:1,2,3", "nan,0,0:1,1,1"}) {
    EXPECT_EQ(solve({"--preview", at("a.png"), "--camera", camera}).exit_code, 2) << camera;
  }
  EXPECT_EQ(solve({"--camera", "8,-6,5:2,2,0.5"}).exit_code, 2);
}

TEST_F(DisplayOptions, ThePageIsNamed_AndAsksNothingOfTheNetwork) {
  const Outcome outcome = solve({"--viewer", at("lit.html")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("page "));
  const std::string page = read("lit.html");
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("<h1>lit.obj</h1>"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
}

TEST_F(DisplayOptions, WithoutLightAreUsageErrors) {
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--curve", "shoulder"}, {"--falsecolor"}, {"--viewer", at("a.html")}}) {
    std::vector<std::string> args{write("lit.obj", kLitScene), "-o", at("out.glb")};
    args.insert(args.end(), options.begin(), options.end());
    EXPECT_EQ(outcome_of(&run_radfix, args).exit_code, 2) << options.front();
  }
  EXPECT_EQ(solve({"--curve", "gamma"}).exit_code, 2);
  EXPECT_EQ(solve({"--curve", "shoulder", "--falsecolor"}).exit_code, 2);
}

}  // namespace
}  // namespace rad::cli
