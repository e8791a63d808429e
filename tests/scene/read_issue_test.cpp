// Issues are kept up to a cap for each kind, and none goes uncounted.
#include "scene/read_issue.h"

#include <gtest/gtest.h>

#include <string>

namespace rad::scene {
namespace {

std::uint64_t total(const ReadIssues& issues, ReadIssueKind kind) {
  std::uint64_t sum = 0;
  for (const ReadIssue& issue : issues.all()) sum += issue.kind == kind ? issue.count : 0;
  return sum;
}

TEST(ReadIssues, StartEmpty) {
  const ReadIssues issues;
  EXPECT_TRUE(issues.all().empty());
  EXPECT_FALSE(issues.any(ReadIssueKind::ParseError));
}

TEST(ReadIssues, KeepWhatAndWhere) {
  ReadIssues issues;
  issues.add(
      {ReadIssueKind::IndexOutOfRange, "vertex index 9 exceeds the 8 vertices read so far", {"a.obj", 12, {}, ""}});
  ASSERT_EQ(issues.all().size(), 1U);
  EXPECT_EQ(issues.all()[0].place.line, 12U);
  EXPECT_EQ(issues.all()[0].count, 1U);
  EXPECT_TRUE(issues.any(ReadIssueKind::IndexOutOfRange));
  EXPECT_FALSE(issues.any(ReadIssueKind::ParseError));
}

TEST(ReadIssues, BeyondTheCapOnlyCount) {
  ReadIssues issues;
  issues.add({ReadIssueKind::MissingResource, "no such file", {}});
  constexpr std::uint64_t kAdded = 1000;
  for (std::uint64_t line = 1; line <= kAdded; ++line) {
    issues.add({ReadIssueKind::ParseError, "line " + std::to_string(line), {"", line, {}, ""}});
  }
  EXPECT_EQ(issues.all().size(), ReadIssues::kKept + 1);
  EXPECT_EQ(total(issues, ReadIssueKind::ParseError), kAdded);
  EXPECT_EQ(issues.all().back().count, kAdded - ReadIssues::kKept + 1);
  EXPECT_EQ(issues.all().back().place.line, ReadIssues::kKept) << "the first occurrences are kept";
  issues.add({ReadIssueKind::IndexOutOfRange, "another kind", {}});
  EXPECT_EQ(issues.all().size(), ReadIssues::kKept + 2) << "every kind has a cap of its own";
}

TEST(ReadIssues, CarryCountsOfTheirOwnBeyondTheCap) {
  ReadIssues issues;
  for (std::size_t i = 0; i < ReadIssues::kKept + 2; ++i) issues.add({ReadIssueKind::ParseError, "bad", {}, 7});
  EXPECT_EQ(total(issues, ReadIssueKind::ParseError), 7 * (ReadIssues::kKept + 2));
}

TEST(ReadIssues, CountUnsupportedContentByItsName) {
  ReadIssues issues;
  issues.add_unsupported("points", {"", 3, {}, ""});
  issues.add_unsupported("lines", {"", 4, {}, ""});
  issues.add_unsupported("points", {"", 5, {}, ""});
  ASSERT_EQ(issues.all().size(), 2U);
  EXPECT_EQ(issues.all()[0].count, 2U);
  EXPECT_EQ(issues.all()[0].place.line, 3U) << "the place is that of the first";
  EXPECT_EQ(issues.all()[1].count, 1U);
  for (int i = 0; i < 500; ++i) issues.add_unsupported("kind " + std::to_string(i), {});
  EXPECT_EQ(issues.all().size(), ReadIssues::kKept);
  EXPECT_EQ(total(issues, ReadIssueKind::UnsupportedContent), 503U);
}

}  // namespace
}  // namespace rad::scene
