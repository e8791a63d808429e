// The lattice holds every box, however large, small, flat or far away.
#include "geom/lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

using tests::LatticeRandom;

Box box_between(const dvec3& a, const dvec3& b) {
  Box box;
  box.add(a);
  box.add(b);
  return box;
}

bool is_power_of_two(double value) {
  int exponent = 0;
  return value > 0 && std::isfinite(value) && std::frexp(value, &exponent) == 0.5;
}

bool in_range(const Lattice& lattice, const dvec3& point) {
  const dvec3 scaled = (point - lattice.origin) / lattice.pitch;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(std::round(scaled[axis])) < kLatticeLimit)) return false;
  }
  const LatticePoint p = lattice.nearest(point);
  return std::abs(p.x) < kLatticeLimit && std::abs(p.y) < kLatticeLimit && std::abs(p.z) < kLatticeLimit;
}

dvec3 corner(const Box& box, std::uint64_t bits) {
  return {bits & 1 ? box.low.x : box.high.x, bits & 2 ? box.low.y : box.high.y, bits & 4 ? box.low.z : box.high.z};
}

void expect_holds(const Box& box) {
  const Lattice lattice = lattice_for(box);
  ASSERT_TRUE(is_power_of_two(lattice.pitch)) << lattice.pitch;
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_EQ(std::fmod(lattice.origin[axis], lattice.pitch), 0.0) << "origin " << lattice.origin[axis];
  }
  for (std::uint64_t bits = 0; bits < 8; ++bits) {
    ASSERT_TRUE(in_range(lattice, corner(box, bits)))
        << std::hexfloat << "low " << box.low.x << " high " << box.high.x << " pitch " << lattice.pitch;
  }
}

// 2^from to 2^to, either sign.
double any_magnitude(LatticeRandom& random, int from, int to) {
  const double value = std::ldexp(1 + random.unit(), static_cast<int>(random.between(from, to)));
  return random.one_in(2) ? value : -value;
}

dvec3 any_vector(LatticeRandom& random, int from, int to) {
  const double x = any_magnitude(random, from, to), y = any_magnitude(random, from, to);
  return {x, y, any_magnitude(random, from, to)};
}

TEST(Lattice, HoldsBoxesOfEveryMagnitude) {
  LatticeRandom random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const int exponent = static_cast<int>(random.between(-990, 990));
    expect_holds(box_between(any_vector(random, exponent - 3, exponent), any_vector(random, exponent - 3, exponent)));
  }
}

TEST(Lattice, HoldsBoxesFarFromTheOrigin) {
  LatticeRandom random(2);
  for (int trial = 0; trial < 50000; ++trial) {
    const int exponent = static_cast<int>(random.between(-900, 900));
    const dvec3 centre = any_vector(random, exponent, exponent);
    const int extent = exponent - static_cast<int>(random.between(1, 60));
    expect_holds(box_between(centre, centre + any_vector(random, extent, extent)));
  }
}

// Widths of an odd number of units in the last place, so that the centre takes one bit more than double holds, placed
// so that the lattice origin lies as far from it as it can: half of 2^20 pitches.
TEST(Lattice, HoldsBoxesWhoseCentreIsRounded) {
  constexpr double kUlp = 0x1p-12;  // between 2^40 and 2^41
  for (const double magnitude : {0x1p40, 0x1.fp40}) {
    for (double width = 8191; width < 0x1p20; width = 2 * std::floor(width * 1.0002 / 2) + 1) {
      const double step = std::ldexp(lattice_for(box_between({0, 0, 0}, {width * kUlp, 0, 0})).pitch, 20);
      for (double steps = 0.5; steps < 4; ++steps) {
        const double centre = magnitude + steps * step;
        expect_holds(box_between({centre - (width - 1) / 2 * kUlp, 0, 0}, {centre + (width + 1) / 2 * kUlp, 0, 0}));
        expect_holds(box_between({centre - (width + 1) / 2 * kUlp, 0, 0}, {centre + (width - 1) / 2 * kUlp, 0, 0}));
      }
    }
  }
}

TEST(Lattice, HoldsFlatBoxesPointsAndTheEndsOfTheDoubleRange) {
  constexpr double kLargest = std::numeric_limits<double>::max(), kSmallest = std::numeric_limits<double>::min();
  expect_holds(box_between({0, 0, 0}, {0, 0, 0}));
  expect_holds(box_between({5, 5, 5}, {5, 5, 5}));
  expect_holds(box_between({1e300, -1e300, 0}, {1e300, -1e300, 0}));
  expect_holds(box_between({1e-300, 1e-300, 1e-300}, {1e-300, 1e-300, 1e-300}));
  expect_holds(box_between({3, 0, 0}, {3, 7, 0}));
  expect_holds(box_between({-kLargest, -kLargest, -kLargest}, {kLargest, kLargest, kLargest}));
  expect_holds(box_between({kLargest, kLargest, kLargest}, {kLargest / 2, kLargest, kLargest}));
  expect_holds(box_between({kSmallest, kSmallest, kSmallest}, {-kSmallest, -kSmallest, -kSmallest}));
  expect_holds(box_between({4e-324, 0, 0}, {0, 0, 0}));
}

TEST(Lattice, RoundsByAtMostHalfThePitchAlongEveryAxis) {
  LatticeRandom random(3);
  for (int trial = 0; trial < 5000; ++trial) {
    const int exponent = static_cast<int>(random.between(-900, 900));
    const dvec3 low = any_vector(random, exponent, exponent + 10);
    const dvec3 size = any_vector(random, exponent, exponent + 3);
    const Box box = box_between(low, low + size);
    const Lattice lattice = lattice_for(box);
    for (int i = 0; i < 8; ++i) {
      const dvec3 p{low.x + random.unit() * size.x, low.y + random.unit() * size.y, low.z + random.unit() * size.z};
      const dvec3 back = lattice.position(lattice.nearest(p));
      const double distance =
          std::hypot((back.x - p.x) / lattice.pitch, (back.y - p.y) / lattice.pitch, (back.z - p.z) / lattice.pitch);
      ASSERT_LE(distance, std::numbers::sqrt3 / 2);
    }
  }
}

TEST(Lattice, UsesAtLeastHalfOfItsRange) {
  LatticeRandom random(4);
  for (int trial = 0; trial < 5000; ++trial) {
    const int exponent = static_cast<int>(random.between(-900, 900));
    const Box box = box_between(any_vector(random, exponent, exponent), any_vector(random, exponent, exponent));
    const double reach = std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z}) / 2;
    if (reach < box.largest_magnitude() * 0x1p-20) continue;
    ASSERT_GE(reach / lattice_for(box).pitch, kLatticeLimit / 2.2) << "a finer pitch would do";
  }
}

TEST(Lattice, PositionsOfLatticePointsComeBackUnchanged) {
  LatticeRandom random(5);
  const Lattice lattice = lattice_for(box_between({-3, 10, 0}, {9, 11, 4}));
  for (int trial = 0; trial < 1000; ++trial) {
    const LatticePoint p = random.point();
    ASSERT_EQ(lattice.nearest(lattice.position(p)), p);
    const dvec3 relative = lattice.position(p) - lattice.origin;
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_EQ(static_cast<double>(static_cast<float>(relative[axis])), relative[axis]);
  }
}

TEST(Lattice, ScalesWithTheModel) {
  const Box box = box_between({-3, 10, 0.125}, {9, 11, 4});
  const Lattice lattice = lattice_for(box), eightfold = lattice_for(box_between(box.low * 8.0, box.high * 8.0));
  EXPECT_EQ(eightfold.pitch, lattice.pitch * 8);
  EXPECT_EQ(eightfold.origin, lattice.origin * 8.0);
}

TEST(Box, StartsEmptyAndTellsItsDiagonalWithoutOverflow) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.diagonal(), 0);
  EXPECT_EQ(box.largest_magnitude(), 0);
  box.add({-2, 0, 0});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.diagonal(), 0);
  box.add({1, 4, 12});
  EXPECT_EQ(box.diagonal(), 13);
  EXPECT_EQ(box.largest_magnitude(), 12);
  EXPECT_TRUE(std::isfinite(box_between({-8e307, 0, 0}, {8e307, 0, 0}).diagonal()));
}

TEST(Lattice, HoldsWhatItWasMadeFor) {
  LatticeRandom random(23);
  for (int i = 0; i < 1000; ++i) {
    const auto coordinate = [&] { return std::ldexp(random.unit() - 0.5, static_cast<int>(random.between(-60, 60))); };
    const dvec3 a{coordinate(), coordinate(), coordinate()};
    const Box box = box_between(a, {coordinate(), coordinate(), coordinate()});
    EXPECT_TRUE(holds(lattice_for(box), box));
  }
}

TEST(Lattice, HoldsNoBoxThatIsTooLargeOrTooFarAway) {
  const Lattice lattice{0.25, {100, 0, 0}};
  const double reach = 0.25 * (kLatticeLimit - 1);
  EXPECT_TRUE(holds(lattice, box_between({100 - reach, -reach, 0}, {100 + reach, 0, reach})));
  EXPECT_FALSE(holds(lattice, box_between({0, 0, 0}, {100.25 + reach, 0, 0})));
  EXPECT_FALSE(holds(lattice, box_between({0, -reach - 0.25, 0}, {0, 0, 0})));
  EXPECT_FALSE(holds(lattice, Box{}));
}

TEST(Lattice, HoldsNothingWhereItIsNotOne) {
  const Box box = box_between({0, 0, 0}, {1, 1, 1});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double pitch : {0.0, -0.25, 0.3, kInfinity, -kInfinity, std::nan(""), 0x1p-1074, 0x1p-1030}) {
    EXPECT_FALSE(holds({pitch, {0, 0, 0}}, box)) << pitch;
  }
  for (const double origin : {kInfinity, std::nan(""), 1e300}) {
    EXPECT_FALSE(holds({0.25, {0, origin, 0}}, box)) << origin;
  }
}

TEST(Lattice, HasNoNegativeZeroInItsOrigin) {
  Box box;
  box.add({-1, -0.0, -0.25});
  box.add({1, -0.0, 0.2});
  const Lattice lattice = lattice_for(box);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(lattice.origin[axis], 0);
    EXPECT_FALSE(std::signbit(lattice.origin[axis]));
  }
}

}  // namespace
}  // namespace rad::geom
