// What radfix decides for the user and tells: who is seen where faces overlap, what is too thin, which T.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/radfix.h"
#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string kRugOnFloor = R"(o floor
usemtl wood
v 0 0 0
v 4 0 0
v 4 4 0
v 0 4 0
f 1 2 3 4
o rug
usemtl wool
v 1 1 0
v 2 1 0
v 2 2 0
v 1 2 0
f 5 6 7 8
)";

// A pane of 0.02 mm beside a table, in metres.
const std::string kPane = R"(o pane
v 0 0 0
v 4 0 0
v 0 0.00002 0
v 4 0.00002 0
v 0 0 3
v 4 0 3
v 0 0.00002 3
v 4 0.00002 3
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
)";

// Two squares whose corners all but meet: noise of 1e-6, features of 1.
const std::string kNoisy = R"(v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 1.00008 0 0
v 2 0 0
v 2 1 0
v 1.00008 1 0
v 100 0 0
v 101 0 0
v 101 1 0
f 1 2 3 4
f 5 6 7 8
f 9 10 11
)";

class FixDecisions : public InFolder {
 protected:
  json fix(const std::string& model, const std::vector<std::string>& more) {
    const std::string output = at(model == at("out.obj") ? "again.obj" : "out.obj");
    std::vector<std::string> args{model, "-o", output, "--report", "json=" + at("r.json")};
    args.insert(args.end(), more.begin(), more.end());
    outcome_ = outcome_of(&run_radfix, args, {});
    return json::parse(read("r.json"));
  }
  Outcome outcome_;
};

TEST_F(FixDecisions, ThePolicySaysWhoIsSeen) {
  const std::string model = write("rug.obj", kRugOnFloor);
  const auto winner = [&](const std::vector<std::string>& more) {
    const json log = fix(model, more)["coplanar"];
    return log.size() == 1 ? log[0]["winner"]["object"].get<std::string>() + log[0]["rule"].get<std::string>() : "";
  };
  EXPECT_EQ(winner({}), "rugc");
  EXPECT_THAT(outcome_.out, HasSubstr("overlaps in one plane"));
  EXPECT_EQ(winner({"--coplanar-policy", "area"}), "rugc");
  EXPECT_EQ(winner({"--coplanar-policy", "keep-first"}), "floorf");
  EXPECT_EQ(winner({"--coplanar-policy", "keep-last"}), "rugf");
  EXPECT_EQ(winner({"--priority", "wo?d"}), "floora");
  EXPECT_EQ(winner({"--coplanar-policy", "priority", "--priority", "rug"}), "ruga");
}

TEST_F(FixDecisions, ThinFeaturesAreListedBeforeTheyClose) {
  const json report = fix(write("pane.obj", kPane), {});
  ASSERT_EQ(report["thinFeatures"].size(), 1U);
  EXPECT_EQ(report["thinFeatures"][0]["rule"], "RL107");
  EXPECT_NEAR(report["thinFeatures"][0]["area"].get<double>(), 12, 1e-3);
  EXPECT_LT(outcome_.out.find("RL107"), outcome_.out.find("repaired"));
  bool flat = false;
  for (const json& entry : report["ledger"]) flat = flat || entry["operation"] == "flatten-plate";
  EXPECT_TRUE(flat);
  ASSERT_GT(report["thinFeatures"][0]["keptBelow"].get<double>(), 0);
  const json again = fix(at("pane.obj"), {"--tolerance", report["thinFeatures"][0]["keptBelow"].dump()});
  EXPECT_TRUE(again["thinFeatures"].empty());
  EXPECT_EQ(outcome_.exit_code, 0);
}

TEST_F(FixDecisions, AutoFindsTheGapAndSaysSo) {
  const json tolerance = fix(write("noisy.obj", kNoisy), {"--tolerance", "auto"})["tolerance"];
  EXPECT_EQ(tolerance["source"], "auto");
  EXPECT_GT(tolerance["confidence"].get<double>(), 3);
  EXPECT_GT(tolerance["T"].get<double>(), 8e-5);
  EXPECT_THAT(outcome_.out, HasSubstr("auto: no vertex has another vertex or edge between"));
  // The written file records T, which goes before auto.
  const json again = fix(at("out.obj"), {"--tolerance", "auto"});
  EXPECT_EQ(again["tolerance"]["source"], "recorded");
}

TEST_F(FixDecisions, AutoFallsBackToTheDefaultAndSaysSo) {
  const json tolerance = fix(write("rug.obj", kRugOnFloor), {"--tolerance", "auto"})["tolerance"];
  EXPECT_EQ(tolerance["source"], "default");
  EXPECT_EQ(tolerance["confidence"], 0);
  EXPECT_THAT(outcome_.out, HasSubstr("so T is the default"));
}

}  // namespace
}  // namespace rad::cli
