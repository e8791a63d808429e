// How far surfaces may be drawn: what keep_near() refuses, and what drift_of() finds where nothing was refused.
#include "repair/drift.h"

#include <gtest/gtest.h>

#include "tests/repair/drawn_complex.h"
#include "tests/repair/drawn_soup.h"

namespace rad::repair {
namespace {

constexpr std::int64_t kTolerance = 32;
constexpr double kT = kTolerance;
constexpr std::int32_t kWithin = 7 * kTolerance, kBeyond = 9 * kTolerance;
constexpr double kFarthest = 7.5 * kT;
const dvec3 kUp{0, 0, 1};

using Corners = std::array<LatticePoint, 3>;
const Corners kOrigin{{{0, 0, 0}, {6000, 0, 0}, {0, 6000, 0}}};

// One triangle in the floor. Where it was nobody knows, so it is held to its plane.
class HeldSketch : public tests::ComplexSketch {
 public:
  HeldSketch() : ComplexSketch(kT), floor(plane(kUp)), held(piece(floor, {kOrigin.begin(), kOrigin.end()})) {
    complex.keep_near({kOrigin}, kFarthest);
  }

  [[nodiscard]] EdgeKey bottom() { return edge_key(point(kOrigin[0]), point(kOrigin[1])); }

  ClusterId floor;
  PieceId held;
};

TEST(KeepNear, RefusesASplitThatDrawsItsSurfaceOff) {
  HeldSketch sketch;
  EXPECT_FALSE(sketch.complex.split(sketch.bottom(), sketch.point({3000, 0, kBeyond})));
  EXPECT_TRUE(sketch.complex.has_edge(sketch.bottom()));
  EXPECT_EQ(sketch.complex.counts().refused, 1u);
  EXPECT_EQ(sketch.complex.counts().splits, 0u);
  EXPECT_TRUE(sketch.complex.split(sketch.bottom(), sketch.point({3000, 0, kWithin})));
}

// A piece of which nobody knows where it was is held to its plane, beside its outline as well.
TEST(KeepNear, HoldsToThePlaneWhatHasNoOrigin) {
  HeldSketch sketch;
  EXPECT_TRUE(sketch.complex.split(sketch.bottom(), sketch.point({3000, -2 * kBeyond, 0})));
  HeldSketch other;
  EXPECT_FALSE(other.complex.split(other.bottom(), other.point({3000, -2 * kBeyond, kBeyond})));
}

TEST(KeepNear, HoldsToTheTriangleWhatHasAnOrigin) {
  tests::ComplexSketch sketch(kT);
  const ClusterId floor = sketch.plane(kUp);
  const PieceId held = sketch.complex.add_piece({floor, true, 0, 0, false, 0});
  sketch.draw({kOrigin.begin(), kOrigin.end()}, held);
  sketch.complex.keep_near({kOrigin}, kFarthest);
  const EdgeKey bottom = edge_key(sketch.point(kOrigin[0]), sketch.point(kOrigin[1]));
  EXPECT_FALSE(sketch.complex.split(bottom, sketch.point({3000, -kBeyond, 0})));
  EXPECT_TRUE(sketch.complex.split(bottom, sketch.point({3000, -kWithin, 0})));
}

TEST(KeepNear, RefusesAMergeThatMovesAPointTooFar) {
  HeldSketch sketch;
  const PointId far = sketch.point({kBeyond, 0, 0}), near = sketch.point({kWithin, 0, 0});
  EXPECT_FALSE(sketch.complex.merge(sketch.point(kOrigin[0]), far));
  EXPECT_EQ(sketch.complex.counts().merges, 0u);
  EXPECT_TRUE(sketch.complex.merge(sketch.point(kOrigin[0]), near));
}

// Either point would do for the merge, but only one of them leaves both surfaces where they are.
TEST(KeepNear, MergesIntoTheOtherWhereTheFirstIsRefused) {
  tests::ComplexSketch sketch(kT);
  sketch.complex.keep_near({}, kFarthest);
  sketch.piece(sketch.plane(kUp), {{0, 0, -150}, {6000, 0, 0}, {0, 6000, 0}});
  sketch.piece(sketch.plane({0, 1, 0}), {{-20, 0, -300}, {-4000, 0, -3000}, {4000, 0, -3000}});
  const PointId corner = sketch.point({0, 0, -150}), first = sketch.point({-20, 0, -300});
  ASSERT_TRUE(sketch.complex.precedes(first, corner));
  EXPECT_TRUE(sketch.complex.merge_either(first, corner));
  EXPECT_TRUE(sketch.complex.live(corner));
  EXPECT_FALSE(sketch.complex.live(first));
}

TEST(KeepNear, RefusesImprintsOffThePlane) {
  HeldSketch sketch;
  EXPECT_FALSE(sketch.complex.imprint_point(sketch.floor, sketch.point({1000, 1000, kBeyond})));
  EXPECT_TRUE(sketch.complex.imprint_point(sketch.floor, sketch.point({1000, 1000, kWithin})));
}

// Nothing could be said about a plane map that folds.
TEST(KeepNear, DoesNotRefuseWhatKeepsMapsFromFolding) {
  HeldSketch sketch;
  const PointId far = sketch.point({3000, 0, kBeyond});
  EXPECT_TRUE(sketch.complex.split(sketch.bottom(), far, Need::Sound));
  EXPECT_TRUE(sketch.complex.merge(far, sketch.point({3000, 0, -kBeyond}), Need::Sound));
  EXPECT_EQ(sketch.complex.counts().refused, 0u);
}

TEST(KeepNear, HoldsOnlyWhatItIsToldTo) {
  for (const std::uint8_t held : {0, 1}) {
    tests::ComplexSketch sketch(kT);
    sketch.complex.keep_near({kOrigin}, kFarthest, {held});
    const ClusterId floor = sketch.plane(kUp);
    sketch.draw({kOrigin.begin(), kOrigin.end()}, sketch.complex.add_piece({floor, true, 0, 0, false, 0}));
    const EdgeKey bottom = edge_key(sketch.point(kOrigin[0]), sketch.point(kOrigin[1]));
    EXPECT_EQ(sketch.complex.may_imprint(floor, sketch.point({1000, 1000, kBeyond})), held == 0);
    EXPECT_EQ(sketch.complex.split(bottom, sketch.point({3000, -kBeyond, 0})), held == 0);
  }
}

TEST(Merging, GoesWhereSurfacesAreDrawnLess) {
  tests::ComplexSketch sketch(kT);
  sketch.complex.keep_near({kOrigin}, std::numeric_limits<double>::infinity());
  const ClusterId floor = sketch.plane(kUp);
  const PieceId drawn = sketch.complex.add_piece({floor, true, 0, 0, false, 0});
  sketch.draw({{0, 0, 0}, {6000, 0, 100}, {0, 6000, 0}}, drawn);
  sketch.piece(sketch.plane({0, 1, 0}), {{6000, 0, 200}, {5000, 0, 4000}, {7000, 0, 4000}});
  const PointId corner = sketch.point({6000, 0, 100}), other = sketch.point({6000, 0, 200});
  ASSERT_TRUE(sketch.complex.precedes(corner, other));
  EXPECT_TRUE(sketch.complex.merge_either(other, corner));
  EXPECT_TRUE(sketch.complex.live(corner)) << "in the wall, and farther from where the floor was the other way";
}

TEST(Merging, IsNotUndoneByANewPoint) {
  HeldSketch sketch;
  const PointId corner = sketch.point(kOrigin[1]), gone = sketch.point({6100, 0, 0});
  sketch.piece(sketch.floor, {{6100, 0, 0}, {9000, 0, 0}, {9000, 900, 0}});
  ASSERT_TRUE(sketch.complex.merge(gone, corner));
  sketch.complex.refresh_search();
  EXPECT_EQ(sketch.complex.point_at({6101, 1, 0}, kT), corner);
  EXPECT_NE(sketch.complex.point_at({6101, 1, 0}, 0), corner) << "without a reach it is where it was asked for";
}

// What one triangle has become, as if points had been merged on the way.
Conformed become(const Corners& after) {
  Conformed conformed;
  conformed.complex = std::make_unique<Complex>(kT);
  Complex& complex = *conformed.complex;
  complex.keep_near({kOrigin}, std::numeric_limits<double>::infinity());
  const dvec3 normal = glm::cross(geom::as_vector(after[1]) - geom::as_vector(after[0]),
                                  geom::as_vector(after[2]) - geom::as_vector(after[0]));
  const ClusterId cluster = complex.add_cluster(Plane(glm::normalize(normal), after[0]), 1);
  const PieceId piece = complex.add_piece({cluster, true, 0, 0, false, 0});
  for (const LatticePoint& place : after) complex.add_point(place);
  for (PointId k = 0; k < 3; ++k) complex.toggle(edge_key(k, (k + 1) % 3), Item::piece(piece));
  conformed.triangulation.update(complex);
  conformed.counts.complex.merges = 1;
  return conformed;
}

Soup one_triangle() {
  tests::SoupSketch sketch;
  sketch.triangle(kOrigin[0], kOrigin[1], kOrigin[2]);
  return sketch.take();
}

TEST(Drift, IsNoneWhereNothingMovedFar) {
  EXPECT_EQ(drift_of(become(kOrigin), one_triangle(), kTolerance).places, 0u);
  EXPECT_EQ(drift_of(become({{{0, 0, kWithin}, {6000, 0, 0}, {0, 6000, 0}}}), one_triangle(), kTolerance).places, 0u);
}

TEST(Drift, FindsACornerThatIsFarFromWhatWasThere) {
  const Corners after{{{-2 * kBeyond, -2 * kBeyond, 0}, {6000, 0, 0}, {0, 6000, 0}}};
  const Drift drift = drift_of(become(after), one_triangle(), kTolerance);
  EXPECT_GT(drift.places, 0u);
  EXPECT_EQ(drift.first, dvec3(-2 * kBeyond, -2 * kBeyond, 0));
}

// Nothing was added elsewhere, and half of the triangle is gone.
TEST(Drift, FindsASurfaceThatIsLost) {
  const Drift drift = drift_of(become({{{0, 0, 0}, {6000, 0, 0}, {3000, 100, 0}}}), one_triangle(), kTolerance);
  EXPECT_GT(drift.places, 0u);
}

// A strip narrower than 2 T may close to a line.
TEST(Drift, LeavesOutWhatIsThinnerThanTwoT) {
  tests::SoupSketch sketch;
  sketch.triangle(kOrigin[0], kOrigin[1], kOrigin[2]);
  sketch.triangle({0, -20000, 0}, {6000, -20000, 0}, {0, -20000 + kTolerance, 0});
  EXPECT_EQ(drift_of(become(kOrigin), sketch.take(), kTolerance).places, 0u);
}

// Without a merge or a triangle in another plane nothing can have been drawn that far, and nothing is measured.
TEST(Drift, IsMeasuredOnlyWhereSomethingWasMergedOrMoved) {
  Conformed conformed = become({{{0, 0, 0}, {6000, 0, 0}, {3000, 100, 0}}});
  conformed.counts.complex.merges = 0;
  EXPECT_EQ(drift_of(conformed, one_triangle(), kTolerance).places, 0u);
  conformed.counts.residual.rehomed = 1;
  EXPECT_GT(drift_of(conformed, one_triangle(), kTolerance).places, 0u);
}

}  // namespace
}  // namespace rad::repair
