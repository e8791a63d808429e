// The contract of repair: nothing silent, nothing worse, nothing written that was not asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/contracts.h"
#include "cli/radfix.h"
#include "fix_models.h"
#include "run.h"
#include "tests/report/schema_checker.h"
#include "validate/promises.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Outcome radfix(const std::vector<std::string>& args) { return outcome_of(&run_radfix, args, {}); }

class Contract : public InFolder {
 protected:
  [[nodiscard]] std::string write_lit_scene() const {
    write("lit.mtl", kLitMaterials);
    return write("lit.obj", kLitScene);
  }
  [[nodiscard]] json report() const { return json::parse(read("r.json")); }
  [[nodiscard]] std::string report_option() const { return "json=" + at("r.json"); }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(at("")), {}));
  }
  [[nodiscard]] json change(const std::string& kind) const {
    const json all = report();
    for (const json& entry : all["changes"]) {
      if (entry["kind"] == kind) return entry;
    }
    return nullptr;
  }
};

TEST_F(Contract, ReportsHoldToTheSchema) {
  const report::SchemaChecker schema("repair_report.schema.json");
  const std::string lit = write_lit_scene();
  const auto faults = [&](std::vector<std::string> args) {
    args.insert(args.end(), {"--report", report_option()});
    radfix(args);
    return schema.faults(report());
  };
  EXPECT_THAT(faults({lit, "-o", at("a.obj")}), IsEmpty());
  EXPECT_THAT(faults({lit, "-o", at("a.glb"), "--timings", "--check-contracts"}), IsEmpty());
  EXPECT_THAT(faults({lit, "--dry-run"}), IsEmpty());
  EXPECT_THAT(faults({lit, "--until", "isect", "-o", at("a.stage.json")}), IsEmpty());
  EXPECT_THAT(faults({write("box.obj", kBox), "-o", at("a.obj")}), IsEmpty());
  EXPECT_THAT(faults({write("bad.obj", kBox + "f 1 2 99\n"), "-o", at("a.obj")}), IsEmpty());
  EXPECT_THAT(faults({at("bad.obj"), "-o", at("a.obj"), "--unsafe-fixes"}), IsEmpty());
  EXPECT_THAT(faults({lit, "-o", at("a.ply"), "--solve", "--patch-size", "1"}), IsEmpty());
  EXPECT_THAT(faults({lit, "-o", at("a.ply"), "--until", "solve", "--patch-size", "1"}), IsEmpty());
}

TEST_F(Contract, ADryRunWritesNothingAndSaysWhatARealOneWould) {
  const std::string lit = write_lit_scene();
  ASSERT_EQ(radfix({lit, "-o", at("a.obj"), "--report", report_option()}).exit_code, 0);
  const json real = report();
  std::filesystem::remove(at("a.obj"));
  std::filesystem::remove(at("a.mtl"));
  const std::size_t before = files();
  const Outcome outcome = radfix({lit, "--dry-run", "--report", report_option()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\ndry run, nothing written\n"));
  EXPECT_THAT(outcome.out, HasSubstr("would be: "));
  EXPECT_EQ(files(), before);
  EXPECT_EQ(report()["dryRun"], true);
  for (const char* same : {"ledger", "after", "changes", "provenance"}) EXPECT_EQ(report()[same], real[same]) << same;
}

TEST_F(Contract, TheDiffNamesRulesAndPlaces) {
  const Outcome outcome = radfix({write_lit_scene(), "--dry-run", "--diff", "--report", report_option()});
  EXPECT_THAT(outcome.out, HasSubstr("RL110 normal-inconsistent"));
  EXPECT_THAT(outcome.out, HasSubstr("faces of the input cut"));
  EXPECT_THAT(outcome.out, HasSubstr("lit.obj:20  at (2, 2, 0)"));
  EXPECT_EQ(change("cut")["count"], 1);
  EXPECT_EQ(change("cut")["places"][0]["face"]["line"], 20);
  EXPECT_EQ(change("turned")["places"][0]["face"]["line"], 30);
  EXPECT_EQ(change("removed"), nullptr);
  EXPECT_EQ(report()["merged"], json::array());
}

TEST_F(Contract, WhatMovedAndWhatIsGoneHasAPlace) {
  // The second sheet stands off by T/2; the third lies in the first and shares its material.
  const std::string model = write("m.obj",
                                  "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 4.005 0 0\nv 8 0 0\nv 8 4 0\nv 4.005 4 0\n"
                                  "v 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nf 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\n");
  ASSERT_EQ(radfix({model, "--tolerance", "0.01", "-o", at("a.obj"), "--report", report_option()}).exit_code, 0);
  EXPECT_NEAR(report()["distance"]["resultToInput"].get<double>(), 0.005, 1e-3);
  EXPECT_NEAR(report()["distance"]["inputToResult"].get<double>(), 0, 1e-3);
  EXPECT_EQ(change("moved")["count"], 1);
  EXPECT_EQ(change("merged")["count"], 1);
  const auto areas = report()["areas"];
  EXPECT_NEAR(areas[0]["area"].get<double>(), 16 + 4 * 3.995 + 1, 1e-3);
  EXPECT_EQ(areas.back()["stage"], "coplanar");
  EXPECT_NEAR(areas.back()["area"].get<double>(), 32, 0.03);
  const json all = report();
  for (const json& entry : all["ledger"]) {
    if (entry["operation"] != "remove-covered-cell") continue;
    EXPECT_NEAR(entry["areaChange"].get<double>(), -1, 1e-6);
  }
}

TEST_F(Contract, EveryFaceNamesItsSource) {
  ASSERT_EQ(radfix({write("box.obj", kBox), "-o", at("a.obj"), "--report", report_option()}).exit_code, 0);
  json provenance = report()["provenance"];
  EXPECT_EQ(provenance["outputFaces"], 6);
  EXPECT_EQ(provenance["sources"], "0..5");
  EXPECT_EQ(provenance["sections"][0]["file"], at("box.obj"));
  EXPECT_EQ(provenance["places"][0]["records"], "9..14");

  ASSERT_EQ(radfix({write_lit_scene(), "-o", at("a.obj"), "--report", report_option()}).exit_code, 0);
  EXPECT_EQ(report()["provenance"]["outputFaces"], 9);
  EXPECT_EQ(report()["provenance"]["places"][0]["records"], "20 23 26..31");
}

TEST_F(Contract, MeshesNameTheirSourcesToo) {
  ASSERT_EQ(radfix({write_lit_scene(), "-o", at("a.ply"), "--mesh", "--patch-size", "1", "--report", report_option()})
                .exit_code,
            0);
  EXPECT_EQ(report()["provenance"]["outputFaces"], report()["outputs"][0]["figures"]["faces"]);
}

TEST_F(Contract, AnAnnotatedModelHasALegend) {
  const Outcome outcome = radfix({write_lit_scene(), "-o", at("a.obj"), "--annotate", at("what.gltf")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("annotated model " + at("what.gltf")));
  const json gltf = json::parse(read("what.gltf"));
  EXPECT_EQ(gltf["asset"]["extras"]["radfix"]["legend"].size(), 7u);
  std::set<std::string> nodes, materials;
  for (const json& node : gltf["nodes"]) nodes.insert(node.value("name", ""));
  for (const json& material : gltf["materials"]) materials.insert(material["name"]);
  nodes.erase("");
  EXPECT_EQ(nodes, (std::set<std::string>{"cut", "turned", "untouched"}));
  EXPECT_EQ(materials, nodes);
  EXPECT_THAT(radfix({at("lit.obj"), "-o", at("a.obj"), "--annotate", at("what.obj")}).err,
              HasSubstr("annotated models are .glb or .gltf"));
}

TEST_F(Contract, InPlaceKeepsTheOriginal) {
  write("lit.mtl", kLitMaterials);
  const std::string lit = write("lit.obj", kLitScene);
  ASSERT_EQ(radfix({lit, "--in-place"}).exit_code, 0);
  EXPECT_EQ(read("lit.obj.orig"), kLitScene);
  EXPECT_EQ(read("lit.mtl.orig"), kLitMaterials);
  EXPECT_THAT(read("lit.obj"), HasSubstr("# written by radfix"));
  const std::string once = read("lit.obj");
  const Outcome again = radfix({lit, "--in-place"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("lit.obj.orig: is there already"));
  EXPECT_EQ(read("lit.obj"), once);
  EXPECT_EQ(radfix({lit, "--in-place", "-o", at("b.obj")}).exit_code, 2);
  EXPECT_EQ(radfix({lit}).exit_code, 2);
}

TEST_F(Contract, UnsafeFixesLeaveOutWhatCannotBeKept) {
  const std::string model = write("bad.obj", "v nan 0 0\n" + kBox + "f 1 2 3\nf 2 3 99\n");
  EXPECT_THAT(radfix({model, "-o", at("a.obj")}).err, HasSubstr("--unsafe-fixes leaves them out"));
  const Outcome outcome = radfix({model, "-o", at("a.obj"), "--unsafe-fixes", "--report", report_option()});
  EXPECT_NE(outcome.exit_code, 4) << outcome.err;
  EXPECT_EQ(report()["ledger"][0]["operation"], "drop-bad-faces");
  EXPECT_THAT(outcome.out, HasSubstr("faces left out that cannot be kept"));
  EXPECT_THAT(read("a.obj"), Not(HasSubstr("nan")));
}

TEST_F(Contract, FixOnlyCuresWhatIsNamed) {
  const std::string box = write("box.obj", kBoxWithFlippedFace);
  ASSERT_EQ(
      radfix({box, "-o", at("a.obj"), "--fix-only", "normal-inconsistent", "--report", report_option()}).exit_code, 0);
  EXPECT_EQ(report()["stages"]["asked"], json::array({"orient"}));
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> args{write_lit_scene(), "-o", at("b.obj")};
    args.insert(args.end(), more.begin(), more.end());
    const Outcome outcome = radfix(args);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_FALSE(std::filesystem::exists(at("b.obj")));
  };
  refused({"--fix-only", "RL999"}, "no rule is called 'RL999'");
  refused({"--fix-only", "RL101"}, "radfix has no cure for RL101");
  refused({"--fix-only", "RL002"}, "RL002 is cured under --unsafe-fixes only");
  refused({"--fix-only", "RL110", "--until", "isect"}, "--fix-only chooses the stages itself");
  refused({"--fix-only", "RL221"}, "grouper, isect, coplanar would cure RL211 edge-through-face as well");
  EXPECT_EQ(radfix({at("lit.obj"), "-o", at("b.obj"), "--fix-only", "RL211"}).exit_code, 1);
}

TEST_F(Contract, ContractsHoldOnWhatCanBeRepaired) {
  const Outcome outcome =
      radfix({write_lit_scene(), "-o", at("a.glb"), "--check-contracts", "--report", report_option()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("contracts (Table 2)"));
  std::set<std::string> stages;
  const json all = report();
  for (const json& check : all["contracts"]) {
    stages.insert(check["stage"]);
    EXPECT_EQ(check["holds"], true) << check;
  }
  EXPECT_EQ(stages, (std::set<std::string>{"grouper", "isect", "coplanar", "orient"}));
}

TEST_F(Contract, ABrokenContractIsNamed) {
  // Grouper requires 1b, and without orientation nobody has seen to it.
  const Outcome outcome =
      radfix({write("box.obj", kBoxWithFlippedFace), "--skip", "orient", "--dry-run", "--check-contracts"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("contract broken: grouper requires 1b (normal consistency)"));
  EXPECT_THAT(outcome.out, HasSubstr("BROKEN"));
  EXPECT_EQ(broken_contracts({{"isect", "2b", "generated", 4, 3, false}}),
            "isect does not generate 2b (no implicit intersections): 3 places are left");
}

// The paper's Table 2, cell by cell, for its own five filters.
TEST_F(Contract, TableTwoIsThePapers) {
  using scene::Filter;
  using validate::Requirement;
  const auto row = [](Requirement requirement) {
    std::string cells;
    for (const Filter filter : {Filter::Grouper, Filter::Isect, Filter::Coplanar, Filter::Pmesh, Filter::Emesh}) {
      cells += ".RG>"[static_cast<std::size_t>(validate::table_two(filter, requirement))];
    }
    return cells;
  };
  EXPECT_EQ(row(Requirement::SolidModel), ">>>>>");
  EXPECT_EQ(row(Requirement::NormalConsistency), "R>R>>");
  EXPECT_EQ(row(Requirement::MaximalPlanarFaces), "GR>R.");
  EXPECT_EQ(row(Requirement::NoTVertices), "G>>>>");
  EXPECT_EQ(row(Requirement::NoImplicitIntersections), ".GR>>");
  EXPECT_EQ(row(Requirement::NoOverlappingFaces), "..G>.");
  EXPECT_EQ(row(Requirement::SimpleFaces), "...G>");
  EXPECT_EQ(row(Requirement::WellShapedFaces), "...G>");
  EXPECT_EQ(row(Requirement::RadiatorDensity), "...G>");
  EXPECT_EQ(row(Requirement::ReceiverDensity), "....G");
  EXPECT_EQ(row(Requirement::Ziplocking), "G>>>>");
}

}  // namespace
}  // namespace rad::cli
