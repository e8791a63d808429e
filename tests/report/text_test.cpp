#include "report/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "report/text_layout.h"
#include "sample_reports.h"

namespace rad::report {
namespace {

using samples::broken_input;
using samples::clean_input;
using samples::report_on;
using samples::unreadable_input;
using testing::HasSubstr;
using testing::Not;

std::size_t longest_line(const std::string& text) {
  std::istringstream stream(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(stream, line);) longest = std::max(longest, columns(line));
  return longest;
}

TEST(Text, BrokenFile) {
  const std::string out = text(report_on({broken_input()}));
  EXPECT_THAT(out,
              testing::StartsWith("room.obj\n"
                                  "  OBJ, 5.23 kB, 42 faces, 96 vertices, 4 objects, 3 materials, 1 emitting face\n"
                                  "  size 4 x 5 x 2.5 units, diagonal 6.8739, T 0.0002 units (default)\n"
                                  "  unit not stated (--units m), up axis not stated (--up z)\n"
                                  "\n"
                                  "error RL201 t-vertex  2a  2 findings, 6 places\n"
                                  "  room.obj:120  at (1.25, 0, 3.5)  3 T-vertices on an edge of \"floor\"\n"
                                  "  room.obj:9    at (10, 0, 3.5)    3 T-vertices on an edge of \"floor\"\n"
                                  "  fix: radfix repairs it (grouper)\n"
                                  "\n"
                                  "note RL101 open-boundary  1a  1 finding, 1 place\n"
                                  "  room.obj:7  open surface\n"
                                  "  fix: by hand, in the modeller\n"
                                  "\n"
                                  "requirements at stage model\n"
                                  "  1a  solid model, valid facades     note  1 note\n"
                                  "  1b  normal consistency             pass\n"));
  EXPECT_THAT(out, HasSubstr("  2a  no T-vertices                  FAIL  2 errors\n"));
  EXPECT_THAT(out, testing::EndsWith("\n"
                                     "FAIL  2 errors, 1 note at stage model; T 0.0002 units (default)\n"
                                     "next: radfix room.obj -o room_fixed.obj   (repairs it)\n"
                                     "      radlint rule RL201   (what it means)\n"));
  EXPECT_LE(longest_line(out), 80U);
}

TEST(Text, NextCommandNamesTheStageAndWhatCannotBeRepaired) {
  Report report = report_on({broken_input("parts.d/room")});
  report.stage = validate::Stage::Solve;
  EXPECT_THAT(text(report), HasSubstr("\nnext: radfix parts.d/room -o parts.d/room_fixed.obj --mesh   (repairs it)\n"));
  report.inputs[0].path = "anna's house/größe.obj";
  EXPECT_THAT(text(report),
              HasSubstr("\nnext: radfix 'anna'\\''s house/größe.obj' -o 'anna'\\''s house/größe_fixed.obj' "
                        "--mesh   (repairs it)\n"));
  report.inputs[0].result.findings[1].fix.applicability = scene::FixClass::Unsafe;
  EXPECT_THAT(text(report), HasSubstr("\nnext: radlint rule RL201   (what it means and how to repair it)\n"));
}

TEST(Text, CleanFileSaysWhatToDoNext) {
  const std::string out = text(report_on({clean_input()}));
  EXPECT_THAT(out, HasSubstr("\npass  no findings at stage model; T 0.0002 units (default)\n"));
  EXPECT_THAT(out, HasSubstr("next: radlint --stage solve room.obj"));
}

TEST(Text, UnreadableFile) {
  const std::string out = text(report_on({unreadable_input()}));
  EXPECT_THAT(out, HasSubstr("torn.ply\n  PLY, 0 bytes, nothing could be read\n"));
  EXPECT_THAT(out, HasSubstr("  torn.ply byte 17  the header does not end\n"));
  EXPECT_THAT(out, HasSubstr("  2a  no T-vertices                  ?     not checked\n"));
  EXPECT_THAT(out, Not(HasSubstr("fix:")));
}

TEST(Text, WarnsOfACoarseLatticeAndOfWhatWasNotJudged) {
  Report report = report_on({clean_input()});
  EXPECT_THAT(text(report), Not(HasSubstr("warning:")));
  report.inputs[0].result.tolerance->pitches = 9;
  report.inputs[0].result.incomplete = "too dense";
  EXPECT_THAT(text(report), HasSubstr("  warning: T is only 9 steps of the scene lattice"));
  EXPECT_THAT(text(report), HasSubstr("  warning: too dense\n"));
}

TEST(Text, StageThatDoesNotAskSaysSo) {
  Report report = report_on({clean_input()});
  report.stage = validate::Stage::Display;
  EXPECT_THAT(text(report), HasSubstr("  1b  normal consistency             -     not asked at stage display\n"));
}

TEST(Text, KnownUnitAndAxis) {
  Report report = report_on({clean_input()});
  report.inputs[0].metres_per_unit = 1;
  report.inputs[0].units_source = ValueSource::Declared;
  report.inputs[0].up = scene::UpAxis::Y;
  report.inputs[0].up_source = ValueSource::Given;
  const std::string out = text(report);
  EXPECT_THAT(out, HasSubstr("T 0.0002 m = 0.2 mm (default)"));
  EXPECT_THAT(out, HasSubstr("unit m (declared), up axis y (given)"));
}

TEST(Text, ListsTenFindingsOfARule) {
  Report report = report_on({clean_input()});
  for (std::uint64_t line = 1; line <= 22; ++line) {
    report.inputs[0].result.findings.push_back(samples::t_vertex(line, static_cast<double>(line)));
  }
  EXPECT_THAT(text(report), HasSubstr("… 12 more (--max-findings 0 shows all)"));
  EXPECT_THAT(text(report, {.max_findings = 0}), Not(HasSubstr("more (")));
  EXPECT_THAT(text(report, {.max_findings = 21}), HasSubstr("… 1 more"));
}

TEST(Text, LongMessagesWrap) {
  Report report = report_on({broken_input()});
  report.inputs[0].result.findings[0].message = std::string(30, 'x') + " " + std::string(30, 'y') + " end";
  const std::string out = text(report);
  EXPECT_LE(longest_line(out), 80U);
  EXPECT_THAT(out, HasSubstr("  room.obj:120  at (1.25, 0, 3.5)\n    xxx"));
}

TEST(Text, ColourOnlyWhenAsked) {
  EXPECT_THAT(text(report_on({broken_input()})), Not(HasSubstr("\x1b")));
  const std::string out = text(report_on({broken_input()}), {.color = true});
  EXPECT_THAT(out, HasSubstr("\x1b[1;31merror\x1b[0m"));
}

TEST(Text, NamesFromFilesCannotSteerTheTerminal) {
  Report report = report_on({broken_input("a\x1b[2Jb\nc.obj")});
  report.inputs[0].result.findings[0].message = "in \"\x1b]0;x\x07\"";
  const std::string out = text(report);
  EXPECT_THAT(out, Not(HasSubstr("\x1b")));
  EXPECT_THAT(out, HasSubstr("a\xEF\xBF\xBD[2Jb c.obj"));
}

TEST(Text, SeveralFiles) {
  Report report = report_on({clean_input("a.obj"), broken_input("b.obj"), clean_input("c.obj")});
  report.inputs[2].result.findings = {samples::open_boundary()};
  const std::string out = text(report);
  EXPECT_THAT(out, testing::StartsWith("pass  a.obj  42 faces\n\nb.obj\n"));
  EXPECT_THAT(out, HasSubstr("\npass  c.obj  42 faces, 1 note\n"));
  EXPECT_THAT(out, HasSubstr("\n3 files, 1 with findings that fail the run\n"));
  EXPECT_THAT(out, HasSubstr("\nFAIL  2 errors, 2 notes at stage model\n"));
}

TEST(Text, SaysWhyARunWithoutErrorsFails) {
  Report report = report_on({clean_input()});
  report.inputs[0].result.findings = {samples::open_boundary()};
  report.fail_on = FailOn::Note;
  EXPECT_THAT(text(report), HasSubstr("no errors, but the run fails at severity note (--fail-on)"));
}

TEST(Layout, Numbers) {
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(1234567.0), "1.23457e+06");
  EXPECT_EQ(short_number(0.1), "0.1");
  EXPECT_EQ(counted(1, "face"), "1 face");
  EXPECT_EQ(counted(1234567, "face"), "1 234 567 faces");
  EXPECT_EQ(counted(0, "vertex", "vertices"), "0 vertices");
  EXPECT_EQ(byte_size(999), "999 bytes");
  EXPECT_EQ(byte_size(1'500'000), "1.5 MB");
}

TEST(Layout, WrapsAtBlanks) {
  const auto wrapped = [](std::string_view text, std::size_t indent, std::size_t width) {
    std::string out = "x\n";
    append_wrapped(out, text, indent, width);
    return out;
  };
  EXPECT_EQ(wrapped("one two  three ", 0, 7), "x\none two\nthree\n");
  EXPECT_EQ(wrapped(" one zwölf four", 2, 11), "x\n  one zwölf\n  four\n");
  EXPECT_EQ(wrapped("unbreakable word", 1, 4), "x\n unbreakable\n word\n");
  EXPECT_EQ(wrapped("", 2, 4), "x\n");
  EXPECT_EQ(wrapped("  ", 2, 4), "x\n");
}

TEST(Layout, CountsCodePoints) {
  EXPECT_EQ(columns("Größe²"), 6U);
  EXPECT_EQ(padded("ö", 3), "ö  ");
}

TEST(Printable, KeepsWhatCanBeShown) {
  EXPECT_EQ(printable("Größe² 部屋 😀"), "Größe² 部屋 😀");
  EXPECT_EQ(printable("one\ntwo\tthree\u2028four\u2029five"), "one two three four five");
}

TEST(Printable, ReplacesControlsAndWhatIsNoText) {
  EXPECT_EQ(printable("a\xc2\x9b"), "a\uFFFD");  // C1 control
  EXPECT_EQ(printable("\x1b[2J"), "\uFFFD[2J");  // C0 control
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "gnp"),
            "\uFFFDgnp");                                      // right-to-left override
  EXPECT_EQ(printable("\xc0\xaf"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");  // surrogate
  EXPECT_EQ(printable("\xe2\x82"), "\uFFFD\uFFFD");            // cut short
  EXPECT_EQ(printable("\xef\xbf\xbf"), "\uFFFD");              // no character
}

}  // namespace
}  // namespace rad::report
