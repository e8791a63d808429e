#include "batch/result_cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "batch/digest.h"
#include "batch/tool_identity.h"
#include "tests/support/fresh_folder.h"

namespace rad::batch {
namespace {

namespace fs = std::filesystem;

class ResultCacheTest : public testing::Test {
 protected:
  void SetUp() override { folder_ = tests::fresh_folder(); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const fs::path& path, const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }

  [[nodiscard]] std::vector<fs::path> packs() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_ / "cache")) found.push_back(entry.path());
    return found;
  }

  [[nodiscard]] std::string model(const std::string& name) const { return (folder_ / name).string(); }

  void keep(const std::string& name, const std::string& result, const std::vector<fs::path>& companions = {},
            std::uint64_t most_bytes = ResultCache::kUsualBytes) const {
    ResultCache cache(folder_ / "cache", "tool", most_bytes);
    cache.keep(model(name), kSettings, entry_of(*state_of(model(name)), result, companions));
    cache.save();
  }

  [[nodiscard]] std::optional<std::string> find(const std::string& name, const Digest128& settings = kSettings,
                                                const std::string& tool = "tool") const {
    ResultCache cache(folder_ / "cache", tool);
    const auto result = cache.find(model(name), settings);
    return result ? std::optional(std::string(*result)) : std::nullopt;
  }

  static constexpr Digest128 kSettings{1, 2};
  fs::path folder_;
};

TEST_F(ResultCacheTest, GivesBackWhatWasKept) {
  write(folder_ / "a.obj", "v 0 0 0");
  write(folder_ / "b.obj", "v 0 0 0");
  EXPECT_FALSE(find("a.obj"));
  const std::string result("\0any\nbytes\n\n", 12);
  keep("a.obj", result);
  EXPECT_EQ(find("a.obj"), result);
  EXPECT_FALSE(find("b.obj")) << "another path";
  EXPECT_FALSE(find("a.obj", {1, 3})) << "other settings";
  EXPECT_FALSE(find("a.obj", kSettings, "newer tool"));
  keep("b.obj", "other");
  EXPECT_EQ(find("a.obj"), result);
  EXPECT_EQ(find("b.obj"), "other");
}

TEST_F(ResultCacheTest, DamagedEntriesAreNotBelieved) {
  write(folder_ / "a.obj", "v 0 0 0");
  keep("a.obj", "the result");
  const fs::path pack = packs().at(0);
  std::ifstream stream(pack, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(pack, whole.substr(0, length));
    EXPECT_FALSE(find("a.obj")) << length;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write(pack, damaged);
    EXPECT_FALSE(find("a.obj")) << at;
  }
  keep("a.obj", "the result");
  EXPECT_EQ(find("a.obj"), "the result");
}

TEST_F(ResultCacheTest, ChangedModelsAreNoticed) {
  write(folder_ / "a.obj", "v 0 0 0");
  keep("a.obj", "result");
  write(folder_ / "a.obj", "v 0 0 1");
  EXPECT_FALSE(find("a.obj")) << "of the same size, within the same moment";
  write(folder_ / "a.obj", "v 0 0 0");
  EXPECT_EQ(find("a.obj"), "result") << "the content counts";
  fs::last_write_time(folder_ / "a.obj", fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(find("a.obj"), "result");
  fs::remove(folder_ / "a.obj");
  EXPECT_FALSE(find("a.obj"));
}

TEST_F(ResultCacheTest, CompanionsMustBeAsTheyWere) {
  write(folder_ / "a.obj", "v 0 0 0");
  const fs::path there = folder_ / "a b.mtl", absent = folder_ / "none\n.mtl";
  write(there, "newmtl red");
  keep("a.obj", "result", {there, absent});
  EXPECT_TRUE(find("a.obj"));
  write(there, "newmtl blue");
  EXPECT_FALSE(find("a.obj"));
  write(there, "newmtl red");
  EXPECT_TRUE(find("a.obj"));
  write(absent, "");
  EXPECT_FALSE(find("a.obj"));
  fs::remove(absent);
  fs::remove(there);
  EXPECT_FALSE(find("a.obj"));
}

TEST_F(ResultCacheTest, RunsAtTheSameTimeKeepEachOthersResults) {
  write(folder_ / "a.obj", "a");
  write(folder_ / "b.obj", "b");
  ResultCache one(folder_ / "cache", "tool"), two(folder_ / "cache", "tool");
  EXPECT_FALSE(one.find(model("a.obj"), kSettings));
  EXPECT_FALSE(two.find(model("b.obj"), kSettings));
  one.keep(model("a.obj"), kSettings, entry_of(*state_of(model("a.obj")), "of a", {}));
  two.keep(model("b.obj"), kSettings, entry_of(*state_of(model("b.obj")), "of b", {}));
  one.save();
  two.save();
  EXPECT_EQ(find("a.obj"), "of a");
  EXPECT_EQ(find("b.obj"), "of b");
}

TEST_F(ResultCacheTest, IsBoundedAndForgetsWhatWasNotUsed) {
  constexpr std::uint64_t kMost = 10000;
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (int i = 0; i < 20; ++i) {
    const std::string name = std::to_string(i) + "/a.obj";
    fs::create_directories(folder_ / std::to_string(i));
    write(folder_ / name, name);
    keep(name, std::string(1000, 'x'));
  }
  for (const fs::path& pack : packs()) fs::last_write_time(pack, long_ago);
  EXPECT_TRUE(find("3/a.obj"));  // used: now the youngest
  keep("19/a.obj", "new", {}, kMost);
  EXPECT_TRUE(find("3/a.obj"));
  EXPECT_TRUE(find("19/a.obj"));
  std::uintmax_t bytes = 0;
  for (const fs::path& pack : packs()) bytes += fs::file_size(pack);
  EXPECT_LE(bytes, kMost);
  EXPECT_GE(bytes, kMost / 2);
}

TEST_F(ResultCacheTest, OneFolderIsBoundedToo) {
  for (int i = 0; i < 20; ++i) write(folder_ / (std::to_string(i) + ".obj"), "v");
  for (int i = 0; i < 20; ++i) keep(std::to_string(i) + ".obj", std::string(1000, 'x'), {}, 10000);
  EXPECT_LE(fs::file_size(packs().at(0)), 10000U);
  EXPECT_TRUE(find("19.obj"));
}

TEST_F(ResultCacheTest, FolderThatCannotBeMadeKeepsNothing) {
  write(folder_ / "file", "");
  write(folder_ / "a.obj", "v");
  ResultCache cache(folder_ / "file", "tool");
  cache.keep(model("a.obj"), kSettings, entry_of(*state_of(model("a.obj")), "result", {}));
  cache.save();
  EXPECT_FALSE(cache.find(model("a.obj"), kSettings));
}

TEST_F(ResultCacheTest, StampsProveNothingWithinATick) {
  write(folder_ / "a.obj", "v 0 0 0");
  auto state = state_of(model("a.obj"));
  state->content = {};  // what it would be if another write had come within the tick
  EXPECT_FALSE(is_as_it_was(model("a.obj"), state));
  state->seen += 10'000'000'000;  // seen long after the last change
  EXPECT_TRUE(is_as_it_was(model("a.obj"), state));
}

TEST(Digest, TellsPartsApart) {
  EXPECT_EQ(Digest().add("a").add("bc").hex(), Digest().add("a").add("bc").hex());
  EXPECT_NE(Digest().add("a").add("bc").hex(), Digest().add("ab").add("c").hex());
  EXPECT_NE(Digest().add("").add("a").hex(), Digest().add("a").hex());
  EXPECT_EQ(digest_of("").size(), 32U);
}

TEST(ToolIdentity, IsTheSameThroughoutARun) {
  EXPECT_EQ(tool_identity(), tool_identity());
  EXPECT_EQ(tool_identity().size(), 32U);
}

}  // namespace
}  // namespace rad::batch
