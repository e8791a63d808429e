// radfix filter by filter: which run, what is written between them, and that a chain of them is one run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/radfix.h"
#include "fix_models.h"
#include "run.h"
#include "tests/report/schema_checker.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Outcome radfix(const std::vector<std::string>& args) { return outcome_of(&run_radfix, args, {}); }

std::string corpus_model(const std::string& name) { return std::string(RAD_SOURCE_DIR) + "/corpus/models/" + name; }

class Stages : public InFolder {
 protected:
  [[nodiscard]] std::string write_lit_scene() const {
    write("lit.mtl", kLitMaterials);
    return write("lit.obj", kLitScene);
  }
  [[nodiscard]] json parsed(const std::string& name) const { return json::parse(read(name)); }

  // Every filter by itself, from stage file to stage file; the last one writes `to`.
  void run_chain(const std::string& model, const std::string& to) const {
    std::string from = model;
    const std::vector<std::string> filters{"orient", "grouper", "isect", "coplanar", "orient"};
    for (std::size_t i = 0; i < filters.size(); ++i) {
      const std::string next = i + 1 == filters.size() ? to : at("step" + std::to_string(i) + ".stage.json");
      const Outcome outcome = radfix({from, "--only", filters[i], "-o", next});
      EXPECT_LE(outcome.exit_code, 1) << filters[i] << outcome.err;
      from = next;
    }
  }
};

TEST_F(Stages, UnknownNamesGetASuggestion) {
  const auto refused = [&](const std::vector<std::string>& args, const std::string& words) {
    std::vector<std::string> all{write("box.obj", kBox), "-o", at("out.obj")};
    all.insert(all.end(), args.begin(), args.end());
    const Outcome outcome = radfix(all);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
  };
  refused({"--until", "gruoper"}, "--until: there is no stage 'gruoper'; did you mean grouper?");
  refused({"--only", "isect,coplaner"}, "--only: there is no stage 'coplaner'; did you mean coplanar?");
  refused({"--skip", "repare"}, "--skip: there is no stage 'repare'; did you mean repair?");
  refused({"--only", "repair"}, "--only: there is no stage 'repair'");
  refused({"--only", "isect", "--until", "isect"}, "--only and --until exclude each other");
  refused({"--only", "isect", "--mesh"}, "--only names all stages that run");
  refused({"--until", "isect", "--solve"}, "--until isect ends before what --solve asks for");
  refused({"--only", "emesh"}, "emesh works on the patches that pmesh makes");
  refused({"--mesh", "--skip", "pmesh"}, "emesh works on the patches that pmesh makes");
  refused({"--only", "pmesh,bake"}, "bake shows what solve found");
}

TEST_F(Stages, EachDoesItsPartOnly) {
  const std::string lit = write_lit_scene();
  const auto operations = [&](const std::string& option, const std::string& stages) {
    EXPECT_LE(radfix({lit, option, stages, "-o", at("out.obj"), "--report", "json=" + at("r.json")}).exit_code, 1);
    std::set<std::string> found;
    const json done = parsed("r.json");
    for (const json& entry : done["ledger"]) found.insert(entry["stage"].get<std::string>());
    return found;
  };
  EXPECT_EQ(operations("--only", "orient"), std::set<std::string>{"orient"});
  EXPECT_EQ(operations("--until", "isect"), (std::set<std::string>{"grouper", "isect"}));
  EXPECT_EQ(operations("--skip", "orient"), (std::set<std::string>{"grouper", "isect"}));
  EXPECT_EQ(operations("--skip", "repair"), std::set<std::string>{});
  EXPECT_EQ(parsed("r.json")["stages"]["asked"], json::array());
}

TEST_F(Stages, OrientKeepsThePolygonsAndTheirVertices) {
  const Outcome outcome = radfix({write("box.obj", kBoxWithFlippedFace), "--only", "orient", "-o", at("out.obj")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read("out.obj"), HasSubstr("\nf 5 6 7 8\n"));
  EXPECT_THAT(read("out.obj"), HasSubstr("\nf 8 4 1 5\n"));
}

TEST_F(Stages, GrouperLeavesIntersectionsAndIsectOverlaps) {
  // Two sheets that cross, and two that overlap in one plane.
  const std::string model = write("m.obj",
                                  "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 1 -1\nv 2 3 -1\nv 2 3 1\nv 2 1 1\n"
                                  "v 10 0 0\nv 14 0 0\nv 14 4 0\nv 10 4 0\nv 12 1 0\nv 16 1 0\nv 16 3 0\nv 12 3 0\n"
                                  "o a\nf 1 2 3 4\no b\nf 5 6 7 8\no c\nf 9 10 11 12\no d\nf 13 14 15 16\n");
  const auto rules = [&](const std::string& until) {
    EXPECT_EQ(radfix({model, "--until", until, "-o", at("out.ply"), "--report", "json=" + at("r.json")}).exit_code, 0);
    std::set<std::string> found;
    const json done = parsed("r.json");
    for (const auto& [rule, total] : done["after"]["byRule"].items()) {
      if (total["severity"] == "error") found.insert(rule);
    }
    return found;
  };
  EXPECT_EQ(rules("grouper"), (std::set<std::string>{"RL210", "RL220"}));
  EXPECT_EQ(rules("isect"), std::set<std::string>{"RL220"});
  EXPECT_EQ(rules("coplanar"), std::set<std::string>{});
}

TEST_F(Stages, CoplanarRefusesWhatIsNotCut) {
  const std::string model =
      write("m.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 1 0\nv 6 1 0\nv 6 3 0\nv 2 3 0\nf 1 2 3 4\nf 5 6 7 8\n");
  const Outcome outcome = radfix({model, "--only", "coplanar", "-o", at("out.obj")});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("run grouper and isect before it"));
  EXPECT_FALSE(std::filesystem::exists(at("out.obj")));
}

TEST_F(Stages, AChainOfFiltersIsOneRun) {
  for (const std::string name :
       {"furnished_room.obj", "lamp_post.obj", "two_room_flat.obj", "lamp_post_repaired.obj"}) {
    SCOPED_TRACE(name);
    for (const std::string to : {"out.ply", "out.glb"}) {
      ASSERT_EQ(radfix({corpus_model(name), "-o", at("one_" + to)}).exit_code, 0);
      run_chain(corpus_model(name), at("chain_" + to));
      EXPECT_EQ(read("chain_" + to), read("one_" + to)) << to;
    }
  }
}

TEST_F(Stages, FilesHoldToTheSchema) {
  const report::SchemaChecker schema("stage.schema.json");
  run_chain(write_lit_scene(), at("out.stage.json"));
  for (const std::string name :
       {"step0.stage.json", "step1.stage.json", "step2.stage.json", "step3.stage.json", "out.stage.json"}) {
    EXPECT_THAT(schema.faults(parsed(name)), IsEmpty()) << name;
  }
  EXPECT_EQ(parsed("step2.stage.json")["stage"], "isect");
  EXPECT_FALSE(parsed("step2.stage.json")["planes"].empty());
  EXPECT_EQ(parsed("step2.stage.json")["overlaps"], "kept");
  EXPECT_EQ(parsed("step3.stage.json")["overlaps"], "resolved");
}

TEST_F(Stages, SourcesAndLedgerAreCarriedThrough) {
  run_chain(write_lit_scene(), at("out.stage.json"));
  const json stage = parsed("out.stage.json");
  EXPECT_EQ(stage["sources"][0]["file"], at("lit.obj"));
  std::set<std::uint64_t> lines;
  for (const json& face : stage["faces"]) {
    for (const json& source : face["sources"]) lines.insert(source[1].get<std::uint64_t>());
  }
  // The bottom of the box and the ground below it look opposite ways: both stay.
  EXPECT_EQ(lines, (std::set<std::uint64_t>{20, 23, 26, 27, 28, 29, 30, 31}));
  std::set<std::string> stages;
  for (const json& entry : stage["ledger"]) stages.insert(entry["stage"].get<std::string>());
  EXPECT_EQ(stages, (std::set<std::string>{"grouper", "isect", "orient"}));
}

TEST_F(Stages, FiltersWorkOnStandardInputAndOutput) {
  const std::string lit = write_lit_scene();
  const std::string program = RAD_RADFIX;
  const std::string pipe = program + " --only orient " + lit + " -o - | " + program + " --only grouper | " + program +
                           " --only isect - -o - | " + program + " --only coplanar | " + program +
                           " --only orient - -o " + at("piped.ply") + " > " + at("log.txt");
  ASSERT_EQ(std::system(("bash -c '" + pipe + "'").c_str()), 0);
  ASSERT_EQ(radfix({lit, "-o", at("one.ply")}).exit_code, 0);
  EXPECT_EQ(read("piped.ply"), read("one.ply"));
}

TEST_F(Stages, NothingButTheModelGoesToStandardOutput) {
  const Outcome outcome = radfix({write("box.obj", kBox), "-o", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["format"], "radfix-stage");
  EXPECT_EQ(json::parse(outcome.out)["faces"].size(), 6u);
}

TEST_F(Stages, AStageFileIsNoMesh) {
  const Outcome outcome = radfix({write("box.obj", kBox), "--mesh", "-o", at("out.stage.json")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a stage file holds models up to orient"));
}

TEST_F(Stages, AMeshComesFromAStageFile) {
  const std::string lit = write_lit_scene();
  const std::vector<std::string> coarse{"--patch-size", "1", "--element-size", "0.5"};
  run_chain(lit, at("fixed.stage.json"));
  std::vector<std::string> chain{at("fixed.stage.json"), "--only", "pmesh,emesh,solve,bake", "-o", at("a.ply")};
  std::vector<std::string> whole{lit, "--solve", "-o", at("b.ply")};
  for (auto* args : {&chain, &whole}) args->insert(args->end(), coarse.begin(), coarse.end());
  EXPECT_EQ(radfix(chain).exit_code, 0);
  EXPECT_EQ(radfix(whole).exit_code, 0);
  EXPECT_THAT(read("a.ply"), HasSubstr("B_r"));
}

TEST_F(Stages, TheMeshStagesCanBeLeftOutToo) {
  const std::string lit = write_lit_scene();
  const auto mesh = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args{lit, "-o", at("a.ply"), "--patch-size", "1", "--report", "json=" + at("r.json")};
    args.insert(args.end(), more.begin(), more.end());
    EXPECT_EQ(radfix(args).exit_code, 0);
    return parsed("r.json");
  };
  const json patches = mesh({"--until", "pmesh"});
  EXPECT_EQ(patches["mesh"]["elements"], patches["mesh"]["patches"]);
  const json solved = mesh({"--until", "solve"});
  EXPECT_TRUE(solved["solution"]["exposure"].is_null());
  EXPECT_THAT(read("a.ply"), Not(HasSubstr("B_r")));
}

}  // namespace
}  // namespace rad::cli
