#include "config/path_glob.h"

#include <gtest/gtest.h>

namespace rad::config {
namespace {

TEST(PathGlob, StarsStayWithinANameAndDoubleStarsDoNot) {
  EXPECT_TRUE(path_matches("a/*.obj", "a/b.obj"));
  EXPECT_FALSE(path_matches("a/*.obj", "a/b/c.obj"));
  EXPECT_TRUE(path_matches("a/**/*.obj", "a/b/c/d.obj"));
  EXPECT_TRUE(path_matches("a/**/*.obj", "a/d.obj"));
  EXPECT_TRUE(path_matches("**", "a/b"));
  EXPECT_TRUE(path_matches("**/b/**", "a/b/c"));
  EXPECT_TRUE(path_matches("**/b/**", "b"));
  EXPECT_FALSE(path_matches("**/b/*", "b"));
  EXPECT_TRUE(path_matches("**/a/**/b/c", "a/x/b/y/b/c"));
  EXPECT_TRUE(path_matches("room[0-9].???", "room7.glb"));
  EXPECT_FALSE(path_matches("room[0-9].???", "roomx.glb"));
  EXPECT_FALSE(path_matches("", "a"));
  EXPECT_TRUE(path_matches("", ""));
}

TEST(PathGlob, ManyStarsTakeNoLongTime) {
  std::string path, glob;
  for (int i = 0; i < 200; ++i) {
    path += "a/";
    glob += "**/a/";
  }
  EXPECT_FALSE(path_matches(glob + "b", path + "c"));
}

TEST(PathPattern, WithoutSlashNamesAnythingBelow) {
  const PathPattern pattern{"legacy", "/models"};
  EXPECT_TRUE(pattern.covers("/models/legacy"));
  EXPECT_TRUE(pattern.covers("/models/a/legacy/b.obj"));
  EXPECT_FALSE(pattern.covers("/models/legacy.obj"));
  EXPECT_FALSE(pattern.covers("/other/legacy"));
  EXPECT_FALSE(pattern.covers("/models"));
  EXPECT_TRUE((PathPattern{"*.stl", "/models"}).covers("/models/a/b.stl"));
}

TEST(PathPattern, WithSlashIsMatchedFromItsFolder) {
  const PathPattern pattern{"site/*", "/models"};
  EXPECT_TRUE(pattern.covers("/models/site/a.obj"));
  EXPECT_TRUE(pattern.covers("/models/site/a/b.obj")) << "a folder stands for all below it";
  EXPECT_FALSE(pattern.covers("/models/x/site/a.obj"));
  EXPECT_TRUE((PathPattern{"./site/", "/models"}).covers("/models/site/a.obj"));
  EXPECT_FALSE((PathPattern{"./site/", "/models"}).covers("/models/x/site/a.obj"));
}

}  // namespace
}  // namespace rad::config
