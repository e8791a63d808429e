// radlint diff over models written down anew, shaken, moved, broken and mended.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/convert_faces.h"
#include "cli/radlint.h"
#include "corpus/generate/models.h"
#include "corpus/judge/scene_variants.h"
#include "corpus/mutate/draft.h"
#include "corpus/mutate/mutator.h"
#include "corpus/random.h"
#include "run.h"
#include "writers/registry.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const corpus::Mutator& mutator_of(std::string_view name) {
  for (const corpus::Mutator& mutator : corpus::mutators()) {
    if (mutator.name == name) return mutator;
  }
  throw std::out_of_range(std::string(name));
}

scene::Scene with_defect(const scene::Scene& scene, std::string_view name, std::uint64_t seed) {
  const corpus::Survey survey(scene);
  corpus::Random random(seed);
  auto mutant = mutator_of(name).plant(survey, random);
  EXPECT_TRUE(mutant) << name;
  return std::move(mutant->scene);
}

/// A furnished room with faults of many kinds.
scene::Scene broken_room() {
  scene::Scene scene = corpus::furnished_room();
  for (const char* name : {"t-vertex within a surface", "face turned over", "face twice, other material",
                           "box pushed through a face", "face taken away", "fin standing in a face"}) {
    scene = with_defect(scene, name, 3);
  }
  return scene;
}

class Diff : public InFolder {
 protected:
  std::string write_scene(const std::string& name, const scene::Scene& scene) const {
    const writers::Writer* writer = writers::writer_for(name);
    const ConvertedFaces converted = faces_for(scene, writer->triangles_only, std::nullopt);
    const writers::WriteResult result = writer->write(writers::Output{converted.scene}, at(name));
    EXPECT_TRUE(result.ok()) << result.problem;
    return at(name);
  }

  static json diff_of(const std::string& old, const std::string& now, int exit_code, const std::string& rules = "ALL") {
    const Outcome outcome = outcome_of(&run_radlint, {"diff", old, now, "--format", "json", "--select", rules});
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    return json::parse(outcome.out);
  }

  static void expect_unchanged(const json& diff) {
    const json& summary = diff["summary"];
    EXPECT_GT(summary["unchanged"], 5);
    EXPECT_EQ(summary["new"], 0) << rows(diff, "new");
    EXPECT_EQ(summary["fixed"], 0) << rows(diff, "fixed");
    EXPECT_EQ(summary["changed"], 0) << rows(diff, "changed");
  }

  static std::string rows(const json& diff, const std::string& status) {
    std::string out;
    for (const json& row : diff["files"][0]["rows"]) {
      if (row["status"] != status) continue;
      const json& finding = (row["new"].empty() ? row["old"] : row["new"])[0];
      out += row["rule"].get<std::string>() + " " + row["change"].dump() + " " + finding["message"].dump() + " " +
             finding["where"]["point"].dump() + "\n";
    }
    return out;
  }
};

TEST_F(Diff, ShuffledAndRenumbered) {
  const scene::Scene room = broken_room();
  const std::string old = write_scene("old.obj", room);
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    expect_unchanged(diff_of(old, write_scene("new.obj", corpus::rewritten(room, seed)), 0));
  }
}

TEST_F(Diff, LightlyPerturbed) {
  const scene::Scene room = broken_room();
  const std::string old = write_scene("old.obj", room);
  for (const double noise : {1e-12, 1e-9, 1e-7}) {  // metres; T is about 0.07 mm
    scene::Scene shaken = room;
    corpus::Random random(5);
    for (auto& vertex : shaken.vertices) {
      for (int axis = 0; axis < 3; ++axis) vertex[axis] += random.real(-noise, noise);
    }
    expect_unchanged(diff_of(old, write_scene("new.obj", shaken), 0));
  }
}

// PLY has no objects and materials, and GLB cuts faces into triangles.
TEST_F(Diff, ExportedAgain) {
  const scene::Scene room = broken_room();
  const std::string obj = write_scene("room.obj", room);
  const std::string ply = write_scene("room.ply", room);
  const std::string glb = write_scene("room.glb", room);
  expect_unchanged(diff_of(obj, ply, 0));
  expect_unchanged(diff_of(ply, glb, 0));
  expect_unchanged(diff_of(obj, glb, 0));
}

// Rules that ask how many corners a face has speak of what any edit does; they are left out.
TEST_F(Diff, ThreePlantedAndTwoMended) {
  scene::Scene both = corpus::furnished_room();
  for (const char* name : {"box pushed through a face", "face twice, other material"}) {
    both = with_defect(both, name, 11);
  }
  scene::Scene old = both;
  for (const char* name : {"t-vertex within a surface", "face turned over"}) old = with_defect(old, name, 12);
  scene::Scene now = both;
  for (const char* name : {"face twice, same material", "corner nudged by T/2", "face twice, other material"}) {
    now = with_defect(now, name, 14);
  }
  const std::string now_path = write_scene("new.obj", corpus::rewritten(now, 1));
  const json diff = diff_of(write_scene("old.obj", old), now_path, 1, "RL110,RL20,RL21,RL220,RL221,RL3");
  EXPECT_EQ(diff["summary"]["new"], 3) << rows(diff, "new");
  EXPECT_EQ(diff["summary"]["fixed"], 2) << rows(diff, "fixed");
  EXPECT_EQ(diff["summary"]["changed"], 0) << rows(diff, "changed");
  EXPECT_GE(diff["summary"]["unchanged"], 2);
}

/// Two boxes in the air, each with a face turned over; the table stands at `table`.
std::string two_boxes(const geom::dvec3& table) {
  std::string out;
  int first = 1;
  const auto add = [&](const char* name, const geom::dvec3& at) {
    out += std::string("o ") + name + "\n";
    for (int i = 0; i < 8; ++i) {
      out += fmt::format("v {} {} {}\n", at.x + ((i + 1) / 2 % 2), at.y + (i / 2 % 2), at.z + (i / 4));
    }
    // The last face looks inward.
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {7, 4, 0, 3}}};
    for (const auto& face : kFaces) {
      out += fmt::format("f {} {} {} {}\n", first + face[0], first + face[1], first + face[2], first + face[3]);
    }
    first += 8;
  };
  add("lamp", {3, 2, 2});
  add("table", table);
  return out;
}

// The faults of a table move with it, even out of the old bounds of the scene, and those of others stay.
TEST_F(Diff, MovedTableKeepsItsFindings) {
  const std::string old = write("old.obj", two_boxes({0, 0, 0}));
  for (const geom::dvec3& place : {geom::dvec3{0.7, 0, 0}, {-3.1, 0.3, 0.017}, {0, 11, 0}}) {
    const json diff = diff_of(old, write("new.obj", two_boxes(place)), 0);
    EXPECT_EQ(diff["summary"]["new"], 0) << rows(diff, "new");
    EXPECT_EQ(diff["summary"]["fixed"], 0) << rows(diff, "fixed");
    EXPECT_EQ(diff["summary"]["changed"], 0) << rows(diff, "changed");
    std::size_t moved = 0;
    for (const json& row : diff["files"][0]["rows"]) moved += row["moved"].get<double>() > 0.5 ? 1 : 0;
    EXPECT_GE(moved, 1U);
    EXPECT_LT(moved, diff["summary"]["unchanged"].get<std::size_t>());
  }
}

TEST_F(Diff, FoldersArePairedByPath) {
  write("v1/a/box.obj", kBox);
  write("v1/b/box.obj", kBoxWithFlippedFace);
  write("v2/a/box.obj", kBoxWithFlippedFace);
  write("v2/b/box.obj", kBox);
  const Outcome outcome = outcome_of(&run_radlint, {"diff", at("v1"), at("v2")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("FAIL  1 new, 1 fixed"));
}

TEST_F(Diff, WritesEveryFormatInOneRun) {
  const std::string box = write("box.obj", kBox);
  const std::string flipped = write("flipped.obj", kBoxWithFlippedFace);
  const Outcome outcome =
      outcome_of(&run_radlint, {"diff", box, flipped, "-q", "--report", "markdown=" + at("d.md"), "--report",
                                "json=" + at("d.json"), "--report", "text=" + at("d.txt")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(read("d.md"), HasSubstr("#### New"));
  EXPECT_EQ(json::parse(read("d.json"))["summary"]["new"], 1);
  EXPECT_THAT(read("d.txt"), HasSubstr("FAIL  1 new"));
}

TEST_F(Diff, UsageErrors) {
  const std::string box = write("box.obj", kBox);
  EXPECT_EQ(outcome_of(&run_radlint, {"diff", box}).exit_code, 2);
  EXPECT_EQ(outcome_of(&run_radlint, {"diff", box, at("none.obj")}).exit_code, 2);
  const Outcome format = outcome_of(&run_radlint, {"diff", box, box, "--format", "sarif"});
  EXPECT_EQ(format.exit_code, 2);
  EXPECT_THAT(format.err, HasSubstr("'sarif' is none of text, json, markdown"));
}

}  // namespace
}  // namespace rad::cli
