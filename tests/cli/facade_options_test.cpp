// Facades as a user meets them: --two-sided, --cap-planar, and the lines of sight of radlint.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/radfix.h"
#include "cli/radlint.h"
#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A sheet over a box, seen from below.
const std::string kSheet =
    "v 0 0 2\nv 4 0 2\nv 4 4 2\nv 0 4 2\n"
    "v 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nv 1 1 1\nv 2 1 1\nv 2 2 1\nv 1 2 1\n"
    "o sheet\nf 1 2 3 4\n"
    "o box\nf 8 7 6 5\nf 9 10 11 12\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\n";

/// A box without its top.
const std::string kOpenBox = kBox.substr(0, kBox.find("f 5 6 7 8\n")) + kBox.substr(kBox.find("f 1 2 6 5\n"));

class FacadeOptions : public InFolder {
 protected:
  [[nodiscard]] json findings(const std::string& path) const {
    return json::parse(outcome_of(&run_radlint, {path, "--format", "json"}).out).at("summary").at("byRule");
  }
  [[nodiscard]] static std::vector<std::string> operations(const json& report) {
    std::vector<std::string> names;
    for (const json& entry : report.at("ledger")) names.push_back(entry.at("operation"));
    return names;
  }
};

TEST_F(FacadeOptions, RadlintNamesTheLineOfSight) {
  const Outcome outcome = outcome_of(&run_radlint, {write("sheet.obj", kSheet)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("RL113 invalid-facade"));
  EXPECT_THAT(outcome.out, HasSubstr("is free"));
}

TEST_F(FacadeOptions, LinesOfSightAreWrittenAsAModel) {
  const std::string sheet = write("sheet.obj", kSheet);
  const Outcome outcome =
      outcome_of(&run_radlint, {sheet, "--report", "leak-line=" + at("leak.obj"), "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  json invalid;
  for (const json& finding : report.at("findings")) {
    if (finding.at("rule") == "RL113") invalid = finding;
  }
  const std::string written = read("leak.obj");
  EXPECT_THAT(written, HasSubstr("\no RL113-" + invalid.at("fingerprint").get<std::string>() + "\nv "));
  EXPECT_THAT(written, HasSubstr("\nl 1 2\n"));
  EXPECT_THAT(written, Not(HasSubstr("l 3 4")));
  EXPECT_EQ(invalid.at("where").at("segment").size(), 2U);
  EXPECT_EQ(invalid.at("where").at("segment").at(1), invalid.at("where").at("point"));
}

TEST_F(FacadeOptions, TwinsAreMadeMarkedAndKnownAgain) {
  const std::string sheet = write("sheet.obj", kSheet);
  for (const std::string name : {"twin.obj", "twin.glb"}) {
    SCOPED_TRACE(name);
    const Outcome outcome =
        outcome_of(&run_radfix, {sheet, "-o", at(name), "--two-sided", "sh*", "--report", "json=" + at("r.json")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("faces doubled, as asked"));
    EXPECT_EQ(operations(json::parse(read("r.json"))).front(), "add-twin");
    const json rules = findings(at(name));
    for (const char* rule : {"RL113", "RL114", "RL222"}) EXPECT_FALSE(rules.contains(rule)) << rule;
    const Outcome again = outcome_of(
        &run_radfix, {at(name), "-o", at("again.obj"), "--two-sided", "sheet", "--report", "json=" + at("r.json")});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(operations(json::parse(read("r.json"))), ElementsAre());
  }
  EXPECT_THAT(read("twin.obj"), HasSubstr("o sheet (twin)\n"));
}

TEST_F(FacadeOptions, APatternThatMatchesNothingIsAUsageError) {
  const Outcome outcome =
      outcome_of(&run_radfix, {write("sheet.obj", kSheet), "-o", at("out.obj"), "--two-sided", "shet"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no object and no material matches 'shet'"));
  EXPECT_EQ(read("out.obj"), "");
}

TEST_F(FacadeOptions, FlatOpeningsAreClosedOnRequestOnly) {
  const std::string box = write("box.obj", kOpenBox);
  EXPECT_EQ(outcome_of(&run_radfix, {box, "-o", at("open.obj")}).exit_code, 0);
  EXPECT_TRUE(findings(at("open.obj")).contains("RL101"));
  const Outcome outcome =
      outcome_of(&run_radfix, {box, "-o", at("shut.obj"), "--cap-planar", "--report", "json=" + at("r.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(operations(json::parse(read("r.json"))), ElementsAre("cap-opening"));
  EXPECT_FALSE(findings(at("shut.obj")).contains("RL101"));
  EXPECT_FALSE(findings(at("shut.obj")).contains("RL104"));
}

}  // namespace
}  // namespace rad::cli
