#include "batch/result_cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "batch/digest.h"
#include "batch/tool_identity.h"

namespace rad::batch {
namespace {

namespace fs = std::filesystem;

class ResultCacheTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("rad_cache_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const fs::path& path, const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }

  [[nodiscard]] std::vector<fs::path> entries() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache")) {
      if (entry.is_regular_file()) found.push_back(entry.path());
    }
    return found;
  }

  fs::path folder_;
};

TEST_F(ResultCacheTest, GivesBackWhatWasKept) {
  const ResultCache cache(folder_ / "cache");
  const std::string key = digest_of("model");
  EXPECT_FALSE(cache.find(key));
  const std::string result("\0any\nbytes\n\n", 12);
  cache.keep(key, result, {});
  EXPECT_EQ(cache.find(key), result);
  EXPECT_FALSE(cache.find(digest_of("another")));
}

TEST_F(ResultCacheTest, DamagedEntriesAreNotBelieved) {
  const ResultCache cache(folder_ / "cache");
  const std::string key = digest_of("model");
  cache.keep(key, "the result", {});
  const fs::path entry = entries().at(0);
  std::ifstream stream(entry, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(entry, whole.substr(0, length));
    EXPECT_FALSE(cache.find(key)) << length;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write(entry, damaged);
    EXPECT_FALSE(cache.find(key)) << at;
  }
  cache.keep(key, "the result", {});
  EXPECT_EQ(cache.find(key), "the result");
}

TEST_F(ResultCacheTest, CompanionsMustBeAsTheyWere) {
  const ResultCache cache(folder_ / "cache");
  const std::string key = digest_of("model");
  const fs::path there = folder_ / "a b.mtl", absent = folder_ / "none.mtl";
  write(there, "newmtl red");
  cache.keep(key, "result", {there, absent});
  EXPECT_TRUE(cache.find(key));
  write(there, "newmtl blue");
  EXPECT_FALSE(cache.find(key));
  write(there, "newmtl red");
  EXPECT_TRUE(cache.find(key));
  write(absent, "");
  EXPECT_FALSE(cache.find(key));
  fs::remove(absent);
  fs::remove(there);
  EXPECT_FALSE(cache.find(key));
}

TEST_F(ResultCacheTest, IsBoundedAndForgetsWhatWasNotUsed) {
  const ResultCache cache(folder_ / "cache", 10000);
  std::vector<std::string> keys;
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (int i = 0; i < 20; ++i) {
    keys.push_back(digest_of(std::to_string(i)));
    cache.keep(keys.back(), std::string(1000, 'x'), {});
    for (const fs::path& entry : entries()) {
      if (entry.string().find(keys.back().substr(2)) != std::string::npos) {
        fs::last_write_time(entry, long_ago + std::chrono::minutes(i));
      }
    }
  }
  EXPECT_TRUE(cache.find(keys[0]));  // used: now the youngest
  cache.trim();
  EXPECT_TRUE(cache.find(keys[0]));
  EXPECT_FALSE(cache.find(keys[1]));
  EXPECT_TRUE(cache.find(keys[19]));
  std::uintmax_t bytes = 0;
  for (const fs::path& entry : entries()) bytes += fs::file_size(entry);
  EXPECT_LE(bytes, 10000U);
  EXPECT_GE(bytes, 5000U);
}

TEST_F(ResultCacheTest, FolderThatCannotBeMadeKeepsNothing) {
  write(folder_ / "file", "");
  const ResultCache cache(folder_ / "file");
  cache.keep(digest_of("model"), "result", {});
  EXPECT_FALSE(cache.find(digest_of("model")));
  cache.trim();
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
