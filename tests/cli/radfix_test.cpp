#include "cli/radfix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/radlint.h"
#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Outcome radfix(const std::vector<std::string>& args) { return outcome_of(&run_radfix, args); }

class Radfix : public InFolder {};

TEST_F(Radfix, CleanModelPassesUnchanged) {
  const std::string box = write("box.obj", kBox);
  const Outcome outcome = radfix({box, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("written unchanged to " + at("out.obj")));
  const std::string written = read("out.obj");
  EXPECT_THAT(written, testing::StartsWith("# written by radfix"));
  EXPECT_THAT(written, HasSubstr("# radfix T="));
  EXPECT_THAT(written, HasSubstr(kBox.substr(0, kBox.find("f "))));
  const json report = json::parse(read("r.json"));
  EXPECT_EQ(report["before"]["errors"], 0);
  EXPECT_EQ(report["after"]["errors"], 0);
  EXPECT_TRUE(report["ledger"].empty());
  EXPECT_EQ(report["tolerance"], report["inputs"][0]["tolerance"]);
}

TEST_F(Radfix, WritesEveryFormatAndJudgesItOnTheSameLattice) {
  const std::string box = write("box.obj", kBox);
  for (const std::string name : {"out.ply", "out.off", "out.glb", "out.gltf"}) {
    const Outcome outcome = radfix({box, "-o", at(name), "--report", "json=" + at("r.json")});
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    const json report = json::parse(read("r.json"));
    const json again = json::parse(outcome_of(&run_radlint, {at(name), "--format", "json"}).out);
    EXPECT_EQ(again["tolerance"]["source"], "recorded") << name;
    EXPECT_EQ(again["tolerance"]["T"], report["inputs"][0]["tolerance"]["T"]) << name;
    EXPECT_EQ(again["inputs"][0]["lattice"], report["inputs"][0]["lattice"]) << name;
  }
  EXPECT_EQ(radfix({box, "-o", at("out.STL")}).exit_code, 0);
}

TEST_F(Radfix, ModelWithErrorsIsRefused) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  const Outcome outcome = radfix({box, "-o", at("out.obj"), "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("RL110 normal-inconsistent"));
  EXPECT_THAT(outcome.err, HasSubstr("Repair is not part of this version"));
  EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
  EXPECT_TRUE(json::parse(read("r.json"))["after"].is_null());
}

TEST_F(Radfix, UsageErrors) {
  const std::string box = write("box.obj", kBox);
  EXPECT_EQ(radfix({at("none.obj"), "-o", at("out.obj")}).exit_code, 2);
  EXPECT_EQ(radfix({at(""), "-o", at("out.obj")}).exit_code, 2);
  EXPECT_EQ(radfix({box, "-o", box}).exit_code, 2);
  EXPECT_THAT(radfix({box, "-o", at("out.dxf")}).err, HasSubstr("one of obj, ply, stl, off, glb, gltf"));
  EXPECT_EQ(radfix({box, "-o", at("none/out.obj")}).exit_code, 2);
  EXPECT_EQ(radfix({box, "-o", at("out.obj"), "--tolerance", "1e-12"}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
}

TEST_F(Radfix, UnreadableAndEmptyInput) {
  EXPECT_EQ(radfix({write("bad.ply", "ply\nformat ascii 1.0\nelement"), "-o", at("out.obj")}).exit_code, 2);
  EXPECT_EQ(radfix({write("empty.obj", "v 0 0 0\n"), "-o", at("out.obj")}).exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
}

}  // namespace
}  // namespace rad::cli
