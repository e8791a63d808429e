#include "readers/recorded_comment.h"

#include <gtest/gtest.h>

#include "tests/readers/read_text.h"

namespace rad::readers {
namespace {

constexpr std::string_view kRecord = "radfix T=0.0625 h=0.001953125 origin=1 -2.5 1e3";
constexpr std::string_view kTriangle = "0 0 0\n1 0 0\n0 1 0\n";

void expect_record(const std::optional<scene::RecordedLattice>& record) {
  ASSERT_TRUE(record);
  EXPECT_EQ(record->tolerance, 0.0625);
  EXPECT_EQ(record->lattice.pitch, 0x1p-9);
  EXPECT_EQ(record->lattice.origin, geom::dvec3(1, -2.5, 1000));
}

TEST(RecordedComment, HoldsToleranceAndLattice) {
  expect_record(record_of_comment(kRecord));
  expect_record(record_of_comment("## " + std::string(kRecord) + "  "));
}

TEST(RecordedComment, IsNoneInAnyOtherForm) {
  for (const char* comment :
       {"", "#", "radfix", "radfix T=", "radfix T=1", "radfix T=1 h=1", "radfix T=1 h=1 origin=1 2",
        "radfix T=1 h=1 origin=1 2 3 4", "radfix T=x h=1 origin=1 2 3", "radfix T=1 h=nan origin=1 2 3",
        "radfix T=1 h=1 origin=1 2 inf", "radfix T=1e999 h=1 origin=1 2 3", "radfix h=1 T=1 origin=1 2 3",
        "Radfix T=1 h=1 origin=1 2 3", "by radfix T=1 h=1 origin=1 2 3", "radfix T=1 h=1 # origin=1 2 3",
        "radfix T=1 h=1 origin= 1 2 3"}) {
    EXPECT_FALSE(record_of_comment(comment)) << comment;
  }
}

TEST(RecordedComment, IsReadFromTheHeadOfObjOffAndPly) {
  const std::string record(kRecord), triangle(kTriangle);
  expect_record(
      tests::read_text("# a\n# " + record + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj").scene.recorded);
  expect_record(tests::read_text("OFF\n# " + record + "\n3 1 0\n" + triangle + "3 0 1 2\n", "m.off").scene.recorded);
  expect_record(tests::read_text("ply\nformat ascii 1.0\ncomment " + record +
                                     "\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
                                     "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                                     triangle + "3 0 1 2\n",
                                 "m.ply")
                    .scene.recorded);
}

TEST(RecordedComment, IsNotReadAfterTheFirstVertex) {
  const std::string record(kRecord), triangle(kTriangle);
  EXPECT_FALSE(tests::read_text("v 0 0 0\n# " + record + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj").scene.recorded);
  EXPECT_FALSE(tests::read_text("OFF\n3 1 0\n" + triangle + "# " + record + "\n3 0 1 2\n", "m.off").scene.recorded);
}

}  // namespace
}  // namespace rad::readers
