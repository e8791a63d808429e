// Contacts of triangles: by hand around the tolerance, and at random against exact intersections.
#include "geom/triangle_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/exact_meeting.h"
#include "tests/support/lattice_random.h"

namespace rad::geom {

// Found by the test framework.
void PrintTo(ContactKind kind, std::ostream* out) {
  constexpr std::array kNames{"None", "Crossing", "EdgeInFace", "Overlap"};
  *out << kNames[static_cast<std::size_t>(kind)];
}

namespace {

using tests::LatticeRandom;
using tests::Meeting;
using Corners = std::array<LatticePoint, 3>;

constexpr std::int64_t kT = 100;
constexpr std::array<bool, 3> kOutline{true, true, true};

TriangleContact contact(const LatticeTriangle& a, const LatticeTriangle& b, std::int64_t tolerance) {
  const Sides a_sides = sides_of(a, b.plane, tolerance), b_sides = sides_of(b, a.plane, tolerance);
  if (all_on_one_side(a_sides) || all_on_one_side(b_sides)) return {};
  return contact_of(a, a_sides, b, b_sides, tolerance);
}

// The kind, which must be the same for all ways to write the pair down.
ContactKind kind_of(const LatticeTriangle& a, const LatticeTriangle& b) {
  const ContactKind kind = contact(a, b, kT).kind;
  EXPECT_EQ(contact(b, a, kT).kind, kind) << "swapped";
  for (std::size_t turn = 1; turn < 3; ++turn) {
    LatticeTriangle turned = a;
    std::rotate(turned.points.begin(), turned.points.begin() + static_cast<std::ptrdiff_t>(turn), turned.points.end());
    std::rotate(turned.boundary.begin(), turned.boundary.begin() + static_cast<std::ptrdiff_t>(turn),
                turned.boundary.end());
    EXPECT_EQ(contact({turned.points, turned.boundary}, b, kT).kind, kind) << "corners rotated";
  }
  return kind;
}

ContactKind kind_of(const Corners& a, const Corners& b) {
  return kind_of(LatticeTriangle(a, kOutline), LatticeTriangle(b, kOutline));
}

// Offsets in hundredths of T that the cases are tried at.
constexpr std::array<std::int32_t, 5> kOffsets{0, 50, 99, 101, 200};
bool within(std::int32_t offset) { return offset <= kT; }

const Corners kFloor{{{0, 0, 0}, {20000, 0, 0}, {0, 20000, 0}}};

TEST(TriangleContact, AWallThroughAFloorCrosses) {
  EXPECT_EQ(kind_of(kFloor, Corners{{{3000, 3000, -5000}, {7000, 3000, -5000}, {5000, 3000, 5000}}}),
            ContactKind::Crossing);
  const TriangleContact crossing =
      contact(LatticeTriangle(kFloor, kOutline),
              LatticeTriangle(Corners{{{3000, 3000, -5000}, {7000, 3000, -5000}, {5000, 3000, 5000}}}, kOutline), kT);
  EXPECT_NEAR(crossing.size, 2000, 1e-6);
  EXPECT_NEAR(crossing.segment[0].y, 3000, 1e-6);
  EXPECT_NEAR(crossing.segment[1].z, 0, 1e-6);
}

TEST(TriangleContact, AWallOnAFloorIsAnEdgeInAFace) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners above{{{3000, 3000, offset}, {7000, 3000, offset}, {5000, 3000, 5000}}};
    EXPECT_EQ(kind_of(kFloor, above), within(offset) ? ContactKind::EdgeInFace : ContactKind::None);
    const Corners below{{{3000, 3000, -offset}, {7000, 3000, -offset}, {5000, 3000, 5000}}};
    EXPECT_EQ(kind_of(kFloor, below), within(offset) ? ContactKind::EdgeInFace : ContactKind::Crossing);
  }
}

TEST(TriangleContact, ACornerOnAFloorIsAnEdgeInAFace) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners spike{{{5000, 5000, offset}, {3000, 3000, 5000}, {6000, 4000, 7000}}};
    EXPECT_EQ(kind_of(kFloor, spike), within(offset) ? ContactKind::EdgeInFace : ContactKind::None);
    EXPECT_EQ(contact(LatticeTriangle(kFloor, kOutline), LatticeTriangle(spike, kOutline), kT).size, 0);
  }
}

TEST(TriangleContact, ASheetOnAFloorOverlaps) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners sheet{{{2000, 2000, offset}, {6000, 2000, offset}, {2000, 6000, offset}}};
    EXPECT_EQ(kind_of(kFloor, sheet), within(offset) ? ContactKind::Overlap : ContactKind::None);
    if (!within(offset)) continue;
    const LatticeTriangle floor(kFloor, kOutline);
    const TriangleContact along = contact(floor, LatticeTriangle(sheet, kOutline), kT);
    EXPECT_TRUE(along.same_facing);
    EXPECT_NEAR(along.size, 8e6, 1e-3);
    const TriangleContact against = contact(floor, LatticeTriangle({sheet[0], sheet[2], sheet[1]}, kOutline), kT);
    EXPECT_EQ(against.kind, ContactKind::Overlap);
    EXPECT_FALSE(against.same_facing);
  }
}

// Two sheets side by side that overlap in a strip of the given width along their long edges.
ContactKind strip_overlap(std::int32_t width) {
  const Corners lower{{{0, 0, 0}, {20000, 0, 0}, {10000, -20000, 0}}};
  const Corners upper{{{0, -width, 0}, {20000, -width, 0}, {10000, 20000, 0}}};
  return kind_of(lower, upper);
}

TEST(TriangleContact, AnOverlapNarrowerThanHalfOfTIsNone) {
  EXPECT_EQ(strip_overlap(0), ContactKind::None);
  EXPECT_EQ(strip_overlap(40), ContactKind::None);
  EXPECT_EQ(strip_overlap(60), ContactKind::Overlap);
  EXPECT_EQ(strip_overlap(200), ContactKind::Overlap);
}

TEST(TriangleContact, FacesThatMeetAlongAnEdgeOfBothDoNotTouch) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners inside{{{0, offset, 0}, {20000, offset, 0}, {10000, offset, 20000}}};
    EXPECT_EQ(kind_of(kFloor, inside), within(offset) ? ContactKind::None : ContactKind::EdgeInFace);
    const Corners outside{{{0, -offset, 0}, {20000, -offset, 0}, {10000, -offset, 20000}}};
    EXPECT_EQ(kind_of(kFloor, outside), ContactKind::None);
    const Corners shorter{{{3000, offset, 0}, {9000, offset, 0}, {5000, offset, 20000}}};
    EXPECT_EQ(kind_of(kFloor, shorter), within(offset) ? ContactKind::None : ContactKind::EdgeInFace);
  }
}

TEST(TriangleContact, FacesThatMeetInACornerOfBothDoNotTouch) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners apart{{{-offset, 0, 0}, {-5000, 3000, 4000}, {-5000, -3000, 6000}}};
    EXPECT_EQ(kind_of(kFloor, apart), ContactKind::None);
    const Corners overlapping{{{offset, offset, 0}, {-5000, 3000, 4000}, {-5000, -3000, 6000}}};
    EXPECT_EQ(kind_of(kFloor, overlapping), within(offset) ? ContactKind::None : ContactKind::EdgeInFace);
  }
}

TEST(TriangleContact, ACornerOnAnEdgeIsLeftToTheSearchForVerticesOnEdges) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners spike{{{9000, offset, 0}, {8000, -5000, 5000}, {10000, -5000, 6000}}};
    EXPECT_EQ(kind_of(kFloor, spike), within(offset) ? ContactKind::None : ContactKind::EdgeInFace);
  }
}

TEST(TriangleContact, EdgesThatCrossAreAnEdgeInAFaceUpToT) {
  for (const std::int32_t offset : kOffsets) {
    SCOPED_TRACE(offset);
    const Corners reaching{{{9000, offset, 5000}, {9000, offset, -5000}, {9000, -5000, 0}}};
    EXPECT_EQ(kind_of(kFloor, reaching), within(offset) ? ContactKind::EdgeInFace : ContactKind::Crossing);
  }
  const Corners short_of_it{{{9000, -1, 5000}, {9000, -1, -5000}, {9000, -5000, 0}}};
  EXPECT_EQ(kind_of(kFloor, short_of_it), ContactKind::None);
}

// The floor as a part of a larger face: its edge along y = 0 lies inside that.
TEST(TriangleContact, ADiagonalIsTheInsideOfItsFace) {
  const LatticeTriangle floor(kFloor, {false, true, true});
  const Corners standing{{{0, 0, 0}, {20000, 0, 0}, {10000, 0, 20000}}};
  EXPECT_EQ(kind_of(floor, LatticeTriangle(standing, kOutline)), ContactKind::EdgeInFace);
  EXPECT_EQ(kind_of(floor, LatticeTriangle(standing, {false, true, true})), ContactKind::Crossing);
  const LatticeTriangle whole(kFloor, kOutline);
  EXPECT_EQ(kind_of(whole, LatticeTriangle(standing, {false, true, true})), ContactKind::EdgeInFace);
}

// A face low enough to lie in the band of the other altogether, but standing in it, not on it.
TEST(TriangleContact, ALowRidgeThroughAFloorIsAnEdgeInAFace) {
  const Corners ridge{{{3000, 3000, -70}, {12000, 3000, -70}, {7000, 3000, 70}}};
  EXPECT_EQ(kind_of(kFloor, ridge), ContactKind::EdgeInFace);
  const Corners step{{{3000, 3000, -20}, {12000, 3000, -20}, {7000, 3000, 99}}};
  EXPECT_EQ(kind_of(kFloor, step), ContactKind::EdgeInFace);
}

LatticePoint permuted(const LatticePoint& p, int permutation) {
  switch (permutation) {
    case 1:
      return {p.y, p.z, p.x};
    case 2:
      return {p.z, p.x, p.y};
    case 3:
      return {p.y, p.x, p.z};
    case 4:
      return {p.x, p.z, p.y};
    case 5:
      return {p.z, p.y, p.x};
    default:
      return p;
  }
}

Corners transformed(const Corners& corners, int permutation, const LatticePoint& by) {
  Corners result;
  std::transform(corners.begin(), corners.end(), result.begin(),
                 [&](const LatticePoint& p) { return tests::moved_by(permuted(p, permutation), by.x, by.y, by.z); });
  return result;
}

bool has_area(const Corners& corners) { return !collinear(corners[0], corners[1], corners[2]); }

// Corners on a coarse grid, each moved by up to `jitter`; a second triangle repeats some of those of `other`.
Corners random_triangle(LatticeRandom& random, std::int64_t step, std::int64_t jitter, const Corners* other) {
  Corners corners;
  do {
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = other != nullptr && random.one_in(4) ? (*other)[i] : random.grid_point(4, step);
      corners[i] = tests::moved_by(corners[i], random.between(-jitter, jitter), random.between(-jitter, jitter),
                                   random.between(-jitter, jitter));
    }
  } while (!has_area(corners));
  return corners;
}

std::string description(const Corners& a, const Corners& b) {
  std::string text;
  for (const Corners* corners : {&a, &b}) {
    for (const LatticePoint& p : *corners) {
      text += " (" + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + ")";
    }
  }
  return text;
}

TEST(TriangleContact, DoesNotDependOnOrderAxesOrPlace) {
  LatticeRandom random(1);
  for (int trial = 0; trial < 4000; ++trial) {
    const std::int64_t jitter = trial % 2 == 0 ? 0 : 2 * kT;
    const Corners a = random_triangle(random, 10000, jitter, nullptr);
    const Corners b = random_triangle(random, 10000, jitter, &a);
    const ContactKind kind = kind_of(a, b);
    const LatticePoint by = random.grid_point(1000000, 1);
    for (int permutation = 0; permutation < 6; ++permutation) {
      ASSERT_EQ(kind_of(transformed(a, permutation, by), transformed(b, permutation, by)), kind)
          << "permutation " << permutation << description(a, b);
    }
  }
}

ContactKind expected_kind(Meeting meeting) {
  switch (meeting) {
    case Meeting::PointInside:
    case Meeting::AlongOneEdge:
      return ContactKind::EdgeInFace;
    case Meeting::Through:
      return ContactKind::Crossing;
    case Meeting::Area:
      return ContactKind::Overlap;
    default:
      return ContactKind::None;
  }
}

// On this grid whatever does not meet is apart by more than T, and whatever meets does so over more than T: on it the
// tolerance must not change the answer.
TEST(TriangleContact, AgreesWithExactIntersectionsOnACoarseGrid) {
  LatticeRandom random(2);
  std::array<int, 8> seen{};
  for (int trial = 0; trial < 6000; ++trial) {
    const Corners a = random_triangle(random, 500000, 0, nullptr);
    const Corners b = random_triangle(random, 500000, 0, &a);
    if (std::is_permutation(a.begin(), a.end(), b.begin())) continue;  // the caller knows these
    const Meeting meeting = tests::exact_meeting(a, b);
    ++seen[static_cast<std::size_t>(meeting)];
    ASSERT_EQ(kind_of(a, b), expected_kind(meeting)) << meeting << description(a, b);
  }
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_GT(seen[i], 0) << static_cast<Meeting>(i) << " was not tried";
}

}  // namespace
}  // namespace rad::geom
