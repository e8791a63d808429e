#include "report/repair_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_reports.h"

namespace rad::report {
namespace {

using samples::broken_input;
using samples::clean_input;
using samples::report_on;
using testing::HasSubstr;
using testing::Not;

RepairReport repaired() {
  RepairReport report{report_on({broken_input()}), report_on({clean_input("out/o.obj")})};
  report.repair = RepairDone::Done;
  report.ledger = {{"grouper", "weld", {"RL302"}, 3, 0.00015, std::nullopt},
                   {"grouper", "weld", {"RL302"}, 2, 0.0003, std::nullopt},
                   {"orient", "turn-face", {"RL110"}, 1, 0, 0.0}};
  return report;
}

TEST(RepairText, SaysWhatWasDoneAndWhatIsLeft) {
  const std::string out = text(repaired());
  EXPECT_THAT(out, testing::StartsWith("room.obj\n  OBJ, "));
  EXPECT_THAT(out, HasSubstr("\n  judged at stage model: 2 errors, 1 note\n"));
  EXPECT_THAT(out, HasSubstr("\nrepaired\n"
                             "  vertices welded to a neighbour                       5  by at most 1.5 T\n"
                             "  faces turned                                         1\n"));
  EXPECT_THAT(out, HasSubstr("\nwritten out/o.obj\n"));
  EXPECT_THAT(out, testing::EndsWith("\npass  read back: no findings at stage model\n"));
}

TEST(RepairText, SaysWhatWasRolledBackAndWhatMovedFar) {
  RepairReport report = repaired();
  report.ledger.push_back({"coplanar", "roll-back", {"RL110", "RL211"}, 1, 0, std::nullopt});
  report.changes = Changes{{}, {{{1, 2, 3}, 0.002, 4}}, 0.002, 0};
  const std::string out = text(report);
  EXPECT_THAT(out, HasSubstr("\n  coplanar rolled back: it made RL110, RL211 worse\n"));
  EXPECT_THAT(out, HasSubstr("\n  1 region moved farther than 4 T, up to 0.002 at (1, 2, 3)\n"));
  EXPECT_THAT(out, Not(HasSubstr("\nchanges\n")));
}

TEST(RepairText, DiffListsRulesAndPlaces) {
  RepairReport report = repaired();
  report.changes = Changes{{{"cut", 12, {{{"room.obj:7", 7, ""}, {1, 2, 3}, 0}}}}, {}, 0.5, 0.25};
  RepairTextOptions options;
  options.diff = true;
  const std::string out = text(report, options);
  EXPECT_THAT(out, HasSubstr("  RL201 t-vertex                             6         0\n"));
  EXPECT_THAT(
      out, HasSubstr("faces of the input cut                              12\n    room.obj:7  at (1, 2, 3)\n    …\n"));
  EXPECT_THAT(out, HasSubstr("nowhere farther than 0.5 from the input"));
}

TEST(RepairText, ADryRunSaysThatNothingWasWritten) {
  RepairReport report = repaired();
  report.dry_run = true;
  const std::string out = text(report);
  EXPECT_THAT(out, HasSubstr("\ndry run, nothing written\n  42 faces, 96 vertices\n"));
  EXPECT_THAT(out, testing::EndsWith("\npass  would be: no findings at stage model\n"));
}

TEST(RepairText, ErrorsThatLaterStagesCureAreNoFailure) {
  RepairReport report = repaired();
  report.after = report_on({broken_input("o.obj")});
  report.awaited = 2;
  EXPECT_THAT(text(report),
              HasSubstr("\npass  read back: 2 errors, 1 note at stage model, 2 of them for later stages\n"));
  report.awaited = 1;
  EXPECT_THAT(text(report), HasSubstr("\nFAIL  read back: "));
}

TEST(RepairText, SaysWhyNothingWasRepaired) {
  RepairReport report{report_on({clean_input()}), report_on({clean_input("o.obj")})};
  report.repair = RepairDone::NotNeeded;
  EXPECT_THAT(text(report), HasSubstr("\nnothing to repair\n"));
  report.repair = RepairDone::Skipped;
  EXPECT_THAT(text(report), HasSubstr("\nrepair left out, as asked\n"));
}

TEST(RepairText, ErrorsThatRemainComeWithTheNextCommand) {
  RepairReport report = repaired();
  report.after = report_on({broken_input("o.obj")});
  report.after->stage = validate::Stage::Display;
  const std::string out = text(report);
  EXPECT_THAT(out, HasSubstr("\nFAIL  read back: 2 errors, 1 note at stage display\n"));
  EXPECT_THAT(out, testing::EndsWith("\nnext: radlint --stage display o.obj\n"));
}

TEST(RepairText, SaysWhereSomethingWasLost) {
  RepairReport report = repaired();
  report.ledger = {{"grouper", "flatten-plate", {}, 2, 0, {}, {{{1, 2, 3}, {"room.obj:7", 7, ""}, 2.5}}}};
  EXPECT_THAT(text(report), HasSubstr("\n  pairs of sides of plates made one plane              2\n"
                                      "    largest: room.obj:7 at (1, 2, 3), 2.5 units²\n"));
}

TEST(RepairText, SaysWhoIsSeenWhereFacesOverlapAndWarnsOfTies) {
  RepairReport report = repaired();
  report.removals = {{{"rug", "wool", {}}, {"room", "wood", {}}, 'c', false, 4, 1.5, {0, 0, 1}}};
  std::string out = text(report, {false, 120, {}});
  EXPECT_THAT(out, HasSubstr("\noverlaps in one plane\n  \"wool\" of \"rug\" before \"wood\" of \"room\", the smaller "
                             "surface: 4 cells, 1.5 units², largest at (0, 0, 1)\n"));
  EXPECT_THAT(out, Not(HasSubstr("tie")));
  report.removals[0].rule = 'e';
  report.removals[0].tie = true;
  out = text(report, {false, 120, {}});
  EXPECT_THAT(out, HasSubstr("warning: nothing but names decided the tie: --priority GLOB says who is to be seen\n"));
}

TEST(RepairText, ListsThinFeaturesBeforeTheLedger) {
  RepairReport report = repaired();
  scene::Finding thin;
  thin.rule = "RL107";
  thin.alias = "thin-feature";
  thin.message = "plate in \"pane\"";
  report.before.inputs[0].result.findings.assign(12, thin);
  const std::string out = text(report);
  EXPECT_LT(out.find("plate in \"pane\""), out.find("\nrepaired\n"));
  EXPECT_THAT(out, HasSubstr("2 more (--report json=PATH lists all)"));
}

TEST(RepairText, SaysHowAutoChose) {
  RepairReport report = repaired();
  auto& tolerance = *report.before.inputs[0].result.tolerance;
  tolerance.choice = geom::AutoChoice{.usual = 0.001};
  EXPECT_THAT(text(report), HasSubstr("auto: no gap of a decade parts noise from features, so T is the default"));
  tolerance.choice = geom::AutoChoice{1.5, 1e-5, 3e-4, 1e-4, 2};
  const std::string out = text(report, {false, 200, {}});
  EXPECT_THAT(out, HasSubstr("between 1e-05 and 0.0003 units from it, 1.5 decades; the default would be 0.0001 units"));
  EXPECT_THAT(out, HasSubstr("warning: 2 distances that the default would keep open are welded at this T"));
}

TEST(RepairText, MeshAndSolution) {
  RepairReport report = repaired();
  report.mesh = MeshFigures{6, 24, 96, 120, 0.5, 0.25, 0.9, 0.4};
  report.solution = SolutionFigures{{}, 17, true, 0.01};
  report.solution->energy.emitted = {100, 100, 100};
  report.solution->energy.absorbed = {60, 60, 60};
  report.solution->energy.escaped = {40, 40, 40};
  const std::string out = text(report, {false, 100, "o.png"});
  EXPECT_THAT(out, HasSubstr("\nmeshed\n"
                             "  6 faces to 24 patches with edges up to 0.5 units\n"
                             "  and 96 elements with edges up to 0.25 units, 120 nodes\n"));
  EXPECT_THAT(out, HasSubstr("\nsolved\n  17 shots, 0 % of the light not yet shot\n"
                             "  of 300 W emitted (all channels) 60 % is absorbed and 40 % leaves the model\n"));
  EXPECT_THAT(out, HasSubstr("  picture o.png\n"));
}

TEST(RepairText, IncompleteRunsDoNotPass) {
  RepairReport report = repaired();
  report.incomplete = true;
  EXPECT_THAT(text(report), HasSubstr("\nFAIL  read back: no findings at stage model; stopped before the end\n"));
}

TEST(RepairText, ColourOnlyWhereAsked) {
  EXPECT_THAT(text(repaired()), Not(HasSubstr("\x1b")));
  EXPECT_THAT(text(repaired(), {true, 80, {}}), HasSubstr("\x1b[1mrepaired"));
}

TEST(RepairText, PathsCannotSteerTheTerminal) {
  RepairReport report = repaired();
  report.after = report_on({clean_input("o\x1b.obj")});
  EXPECT_THAT(text(report), HasSubstr("written o\xEF\xBF\xBD.obj\n"));
}

}  // namespace
}  // namespace rad::report
