// Runs of the program itself over folders: worker processes, limits, cache, shards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "run.h"

namespace rad::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Runs : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    for (int i = 0; i < 12; ++i) {
      std::string box = i % 3 == 0 ? kBoxWithFlippedFace : kBox;
      if (i % 4 == 0) box += "f 1 2 3\n";
      write("models/" + std::string(1, static_cast<char>('a' + i % 5)) + "/" + std::to_string(i) + ".obj", box);
    }
    write("models/bad.ply", "ply\nformat ascii 1.0\nelement");
  }

  // In the folder of the test, so that the report names relative paths; the user's cache is in it as well.
  Outcome radlint(const std::string& args) const {
    const std::string command = "cd '" + at("") + "' && XDG_CACHE_HOME='" + at("home") + "' '" RAD_RADLINT "' " + args +
                                " >'" + at("out") + "' 2>'" + at("err") + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out"), read("err")};
  }
};

TEST_F(Runs, SameBytesForAnyNumberOfJobs) {
  const Outcome one = radlint("models --format json --no-cache --jobs 1");
  EXPECT_EQ(one.exit_code, 1) << one.err;
  EXPECT_EQ(json::parse(one.out)["inputs"].size(), 13U);
  for (const char* jobs : {"2", "5"}) {
    EXPECT_EQ(radlint(std::string("models --format json --no-cache --jobs ") + jobs).out, one.out) << jobs;
  }
}

TEST_F(Runs, WorkersReportWhatOneProcessReports) {
  const std::string path = "models/a/0.obj";
  const json many = json::parse(radlint("models --format json --no-cache").out);
  const json alone = json::parse(radlint(path + " --format json").out);
  std::vector<json> findings;
  for (json finding : many["findings"]) {
    if (finding["where"]["file"] != path) continue;
    finding["input"] = 0;
    findings.push_back(finding);
  }
  EXPECT_EQ(json(findings), alone["findings"]);
}

TEST_F(Runs, CacheGivesTheSameBytesAndNoticesChanges) {
  const Outcome cold = radlint("models --format json --cache kept");
  EXPECT_EQ(radlint("models --format json --cache kept").out, cold.out);
  EXPECT_EQ(radlint("models --format json --no-cache").out, cold.out);
  write("models/b/1.obj", kBoxWithFlippedFace);
  const Outcome changed = radlint("models --format json --cache kept");
  EXPECT_NE(changed.out, cold.out);
  EXPECT_EQ(changed.out, radlint("models --format json --no-cache").out);
  EXPECT_NE(radlint("models --format json --cache kept --units mm").out, changed.out);
}

TEST_F(Runs, CacheNoticesTheLibraryOfMaterials) {
  write("m/a.obj", "mtllib a.mtl\nusemtl lamp\n" + kBox);
  write("m/b.obj", kBox);
  const std::string run = "m --format json --cache kept --select RL006";
  EXPECT_THAT(radlint(run).out, HasSubstr("RL006"));
  write("m/a.mtl", "newmtl lamp\nKd 0.5 0.5 0.5\nKe 1 1 1\n");
  const json report = json::parse(radlint(run).out);
  EXPECT_TRUE(report["findings"].empty());
  EXPECT_EQ(report["inputs"][0]["figures"]["emitters"], 6);
}

TEST_F(Runs, SeveralFilesUseTheCacheOfTheUser) {
  EXPECT_EQ(radlint("models/b/1.obj").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(at("home/radlint")));
  radlint("models");
  EXPECT_TRUE(std::filesystem::exists(at("home/radlint")));
  std::filesystem::remove_all(at("home"));
  radlint("models --no-cache");
  EXPECT_FALSE(std::filesystem::exists(at("home")));
}

TEST_F(Runs, ShardsMergeToTheWholeReport) {
  const Outcome whole = radlint("models --format json");
  std::size_t files = 0;
  for (int i = 1; i <= 4; ++i) {
    const std::string n = std::to_string(i);
    radlint("models --shard " + n + "/4 -q --report json=part" + n + ".json");
    files += json::parse(read("part" + n + ".json"))["inputs"].size();
  }
  EXPECT_EQ(files, 13U);
  const Outcome merged = radlint("merge part3.json part1.json part4.json part2.json --format json");
  EXPECT_EQ(merged.exit_code, 1) << merged.err;
  EXPECT_EQ(merged.out, whole.out);
  EXPECT_EQ(radlint("merge part?.json").out, radlint("models").out);
  const Outcome missing = radlint("merge part1.json part2.json part4.json --format json");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("3/4 missing"));
}

TEST_F(Runs, ShardWithoutFilesIsNoFailure) {
  const Outcome outcome = radlint("models/b/1.obj --shard 1/9000 --format json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(json::parse(outcome.out)["inputs"].empty());
}

TEST_F(Runs, MergeRefusesWhatIsNoReport) {
  write("x.json", "{}");
  EXPECT_EQ(radlint("merge x.json").exit_code, 2);
  EXPECT_EQ(radlint("merge none.json").exit_code, 2);
  EXPECT_EQ(radlint("merge").exit_code, 2);
}

TEST_F(Runs, ExcludedPathsArePassedOver) {
  const auto paths = [&](const std::string& args) {
    std::vector<std::string> found;
    const json report = json::parse(radlint("models --format json --no-cache " + args).out);
    for (const json& input : report["inputs"]) found.push_back(input["path"]);
    return found;
  };
  EXPECT_EQ(paths("").size(), 13U);
  EXPECT_THAT(paths("--exclude a --exclude '*.ply' --exclude 'models/[b-d]/**'"),
              testing::ElementsAre("models/e/4.obj", "models/e/9.obj"));
  EXPECT_EQ(radlint("models --exclude models").exit_code, 2);
  EXPECT_EQ(radlint("models/b/1.obj --exclude b").exit_code, 0) << "a file that is named is judged";
}

TEST_F(Runs, LoopsOfLinksEnd) {
  std::filesystem::create_directory_symlink("..", at("models/a/up"));
  std::filesystem::create_symlink("nowhere.obj", at("models/a/dangling.obj"));
  EXPECT_EQ(json::parse(radlint("models --format json").out)["inputs"].size(), 13U);
}

// A crowd of triangles that takes seconds to judge.
std::string crowd() {
  std::string text;
  for (int i = 0; i < 60000; ++i) {
    const std::string x = std::to_string(i % 97), y = std::to_string(i % 89), z = std::to_string(i % 101);
    text += "v " + x + " " + y + " " + z + "\n";
  }
  for (int i = 1; i + 4000 <= 60000; ++i) {
    text += "f " + std::to_string(i) + " " + std::to_string(i + 1999) + " " + std::to_string(i + 4000) + "\n";
  }
  return text;
}

TEST_F(Runs, TimeLimitCostsOneFile) {
  write("models/crowd.obj", crowd());
  const Outcome outcome = radlint("models --format json --time-limit 0.5");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  const json report = json::parse(outcome.out);
  for (const json& input : report["inputs"]) {
    EXPECT_EQ(input["incomplete"].is_null(), input["path"] != "models/crowd.obj") << input["path"];
  }
  EXPECT_THAT(outcome.out, HasSubstr("the time limit of 0.5 s was reached"));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(Runs, MemoryLimitCostsOneFile) {
  write("models/crowd.obj", crowd());
  const Outcome outcome = radlint("models --format json --memory-limit 20M --jobs 1");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  const json report = json::parse(outcome.out);
  for (const json& input : report["inputs"]) {
    EXPECT_EQ(input["incomplete"].is_null(), input["path"] != "models/crowd.obj") << input["incomplete"];
  }
}
#endif

TEST_F(Runs, InterruptLeavesNoReport) {
  write("models/crowd.obj", crowd());
  write("models/crowd2.obj", crowd());
  const std::string command = "cd '" + at("") +
                              "' && timeout --preserve-status -s INT 0.5 '" RAD_RADLINT
                              "' models --no-cache -q --report json=r.json 2>err";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(read("err"), HasSubstr("interrupted"));
  for (const auto& entry : std::filesystem::directory_iterator(at(""))) {
    EXPECT_EQ(entry.path().filename().string().find("r.json"), std::string::npos) << entry.path();
  }
}

}  // namespace
}  // namespace rad::cli
