// Files of luminous intensities: what is read of them, and what is said of those that cannot be.
#include "readers/photometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "readers/reader.h"

namespace rad::readers {
namespace {

using scene::ReadIssueKind;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kPi = std::numbers::pi;

Photometry uniform(PlaneType type, std::vector<double> vertical, std::vector<double> horizontal) {
  Photometry it{type, std::move(vertical), std::move(horizontal), {}};
  it.intensity.assign(it.vertical.size() * it.horizontal.size(), 100);
  return it;
}

TEST(Photometry, FluxOfTheSameIntensityEverywhere) {
  EXPECT_NEAR(flux_of(uniform(PlaneType::C, {0, 30, 90, 180}, {0})), 400 * kPi, 1e-9);
  EXPECT_NEAR(flux_of(uniform(PlaneType::C, {0, 90, 180}, {0, 90, 180, 270, 360})), 400 * kPi, 1e-9);
  EXPECT_NEAR(flux_of(uniform(PlaneType::C, {0, 90}, {0, 45, 90})), 200 * kPi, 1e-9);
  EXPECT_NEAR(flux_of(uniform(PlaneType::B, {-90, 0, 90}, {-90, 0, 90})), 200 * kPi, 1e-9);
  EXPECT_NEAR(flux_of(uniform(PlaneType::A, {0, 90}, {0, 90})), 200 * kPi, 1e-9);
}

TEST(Photometry, FluxOfACosine) {
  Photometry it{PlaneType::C, {}, {0}, {}};
  for (int angle = 0; angle <= 90; ++angle) {
    it.vertical.push_back(angle);
    it.intensity.push_back(100 * std::cos(angle * kPi / 180));
  }
  EXPECT_NEAR(flux_of(it), 100 * kPi, 0.02);
}

TEST(Photometry, GapsAreNamed) {
  EXPECT_THAT(gap_in(uniform(PlaneType::C, {0, 90}, {0, 90, 180, 270, 360})), IsEmpty());
  EXPECT_THAT(gap_in(uniform(PlaneType::C, {0, 90}, {90, 180, 270})), IsEmpty());
  EXPECT_THAT(gap_in(uniform(PlaneType::C, {0, 90}, {0, 45, 315})), HasSubstr("0 to 315"));
  EXPECT_THAT(gap_in(uniform(PlaneType::C, {0, 90}, {0, 180, 360})), HasSubstr("between 0 and 180"));
  EXPECT_THAT(gap_in(uniform(PlaneType::C, {10, 90}, {0})), HasSubstr("10 to 90"));
  EXPECT_THAT(gap_in(uniform(PlaneType::B, {-90, 90}, {0, 80})), HasSubstr("0 to 80"));
}

ReadResult read(const std::string& name, const std::string& text) {
  Input input;
  input.path = name;
  input.bytes = text;
  return read_bytes(input);
}

std::vector<std::string> said_of(const std::string& name, const std::string& text, ReadIssueKind kind) {
  std::vector<std::string> texts;
  const ReadResult result = read(name, text);
  for (const scene::ReadIssue& issue : result.issues.all()) {
    if (issue.kind == kind) texts.push_back(issue.what);
  }
  return texts;
}

const std::string kIes =
    "IESNA:LM-63-2002\n[TEST] # 1\nTILT=NONE\n1 1000, 1\n3 1 1 1 0 0 0\n1 1 60\n0 45 90\n0\n300,200\n0\n";

TEST(Ies, IsReadByContentOrName) {
  const ReadResult result = read("lamp.txt", kIes);
  EXPECT_THAT(result.issues.all(), IsEmpty());
  EXPECT_TRUE(result.scene.faces.empty());
  EXPECT_EQ(result.scene.format, "ies");
  EXPECT_EQ(result.scene.metres_per_unit, 0.3048);
  EXPECT_EQ(read("old.IES", kIes.substr(kIes.find("TILT"))).scene.format, "ies");
}

TEST(Ies, EveryFaultHasItsLine) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kIes;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::pair<std::string, std::string>> faults = {
      {with("TILT=NONE\n", ""), "no line TILT="},
      {with("1 1000", "1.5 1000"), "no count"},
      {with("1000, 1", "0, 1"), "neither positive nor -1"},
      {with("1000, 1", "1000, 0"), "not positive"},
      {with("3 1 1 1", "3 1 4 1"), "type of planes"},
      {with("3 1 1 1", "3 1 1 3"), "unit of lengths"},
      {with("3 1 1 1", "3000000 1 1 1"), "room"},
      {with("3 1 1 1", "-3 1 1 1"), "room"},
      {with("0 45 90", "0 95 90"), "do not ascend"},
      {with("300,200", "300,x"), "'x'"},
      {with("300,200", "300,nan"), "no number"},
      {with("300,200", "300,-1"), "negative"},
      {with("300,200", "300,200,1"), "follows"},
      {with("300,200\n0", "300,200"), "ends before"},
  };
  for (const auto& [text, what] : faults) {
    const auto said = said_of("lamp.ies", text, ReadIssueKind::PhotometrySyntax);
    ASSERT_EQ(said.size(), 1U) << text;
    EXPECT_THAT(said[0], HasSubstr(what));
  }
  EXPECT_EQ(read("lamp.ies", with("300,200", "300,x")).issues.all()[0].place.line, 9U);
}

TEST(Ies, TiltGapAndFlux) {
  std::string text = kIes;
  text.replace(text.find("TILT=NONE"), 9, "TILT=INCLUDE\n1 2\n0 90\n1 0.8");
  EXPECT_EQ(said_of("a.ies", text, ReadIssueKind::TiltUnsupported).size(), 1U);
  EXPECT_THAT(said_of("a.ies", text, ReadIssueKind::PhotometrySyntax), IsEmpty());
  text = kIes;
  EXPECT_EQ(said_of("a.ies", text.replace(text.find("1000"), 4, "10"), ReadIssueKind::FluxMismatch).size(), 1U);
  text = kIes;
  EXPECT_THAT(said_of("a.ies", text.replace(text.find("1000"), 4, "-1"), ReadIssueKind::FluxMismatch), IsEmpty());
  text = kIes;
  EXPECT_EQ(said_of("a.ies", text.replace(text.find("0 45 90"), 7, "0 45 80"), ReadIssueKind::PlaneGap).size(), 1U);
}

// A value a line; `rows` planes of three intensities.
std::string eulumdat(int symmetry, int planes, double step, int rows, double ratio, const std::string& lamps = "1") {
  const auto line = [](auto value) { return std::to_string(value) + "\r\n"; };
  std::string text = "maker\r\n1\r\n" + line(symmetry) + line(planes) + line(step) + "3\r\n45\r\n";
  for (int i = 0; i < 14; ++i) text += "0\r\n";
  text += "100\r\n" + line(ratio) + "1\r\n0\r\n1\r\n" + lamps + "\r\nlamp\r\n1000\r\n3000\r\n80\r\n20\r\n";
  for (int i = 0; i < 10; ++i) text += "0,5\r\n";
  for (int i = 0; i < planes; ++i) text += line(360.0 / planes * i);
  text += "0\r\n45\r\n90\r\n";
  for (int i = 0; i < rows; ++i) text += "100\r\n100\r\n100\r\n";
  return text;
}

// The same 100 cd/klm over half of all directions: 62.8 % of the flux.
constexpr double kHalf = 62.83;

TEST(Ldt, SymmetriesListTheirPlanes) {
  for (const auto& [symmetry, rows] : std::vector<std::pair<int, int>>{{0, 8}, {1, 1}, {2, 5}, {3, 5}, {4, 3}}) {
    EXPECT_THAT(read("a.ldt", eulumdat(symmetry, 8, 45, rows, kHalf)).issues.all(), IsEmpty()) << symmetry;
    const std::string one_more = eulumdat(symmetry, 8, 45, rows + 1, kHalf);
    EXPECT_EQ(said_of("a.ldt", one_more, ReadIssueKind::PhotometrySymmetry).size(), 1U) << symmetry;
  }
  EXPECT_EQ(said_of("a.ldt", eulumdat(2, 7, 0, 4, kHalf), ReadIssueKind::PhotometrySymmetry).size(), 1U);
  EXPECT_EQ(said_of("a.ldt", eulumdat(0, 8, 30, 8, kHalf), ReadIssueKind::PhotometrySymmetry).size(), 1U);
}

TEST(Ldt, FluxIsHeldAgainstTheLightOutputRatio) {
  EXPECT_EQ(said_of("a.ldt", eulumdat(1, 8, 45, 1, 80), ReadIssueKind::FluxMismatch).size(), 1U);
  EXPECT_THAT(said_of("a.ldt", eulumdat(1, 8, 45, 1, 80, "-1"), ReadIssueKind::FluxMismatch), IsEmpty());
}

TEST(Ldt, TruncatedAnywhereItIsAFault) {
  const std::string text = eulumdat(4, 8, 45, 3, kHalf);
  for (std::size_t size = 1; size + 4 < text.size(); size += 3) {
    EXPECT_FALSE(read("a.ldt", text.substr(0, size)).issues.all().empty()) << size;
  }
}

}  // namespace
}  // namespace rad::readers
