// The tolerance T: its formula, its spelling, its refusals.
#include "geom/tolerance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/lattice_random.h"

namespace rad::geom {
namespace {

ToleranceBasis fine_basis() {
  return {.pitch = 0x1p-30, .diagonal = 100, .median_object_diagonal = 50, .largest_magnitude = 80};
}

TEST(DefaultTolerance, IsAShareOfTheDiagonal) {
  const Tolerance t = default_tolerance(fine_basis());
  EXPECT_EQ(t.source, ToleranceSource::Default);
  EXPECT_EQ(t.diagonal, 100);
  EXPECT_LE(t.length, 1e-3);
  EXPECT_GT(t.length, 1e-3 - 0x1p-30);
  EXPECT_EQ(t.length, static_cast<double>(t.pitches) * 0x1p-30);
}

TEST(DefaultTolerance, IsAShareOfTheMedianObjectWhereThatIsLess) {
  ToleranceBasis basis = fine_basis();
  basis.median_object_diagonal = 0.25;
  EXPECT_NEAR(default_tolerance(basis).length, 0.25e-3, 0x1p-30);
  basis.median_object_diagonal = 0;
  EXPECT_NEAR(default_tolerance(basis).length, 1e-3, 0x1p-30) << "no object has an extent";
}

TEST(DefaultTolerance, CoversEightUnitsInTheLastPlaceOfSinglePrecision) {
  ToleranceBasis basis = fine_basis();
  basis.largest_magnitude = 5000;
  EXPECT_EQ(default_tolerance(basis).source, ToleranceSource::Default) << "doubles do not care";
  basis.single_precision = true;
  const double ulp = std::nextafter(5000.0F, 6000.0F) - 5000.0F;
  EXPECT_EQ(default_tolerance(basis).source, ToleranceSource::SinglePrecision);
  EXPECT_EQ(default_tolerance(basis).length, 8 * ulp);
  basis.largest_magnitude = 4096;
  EXPECT_EQ(default_tolerance(basis).length, 8 * (std::nextafter(4096.0F, 6000.0F) - 4096.0F));
  basis.largest_magnitude = 0;
  EXPECT_EQ(default_tolerance(basis).source, ToleranceSource::Default);
}

TEST(DefaultTolerance, IsNeverBelow32Pitches) {
  ToleranceBasis basis = fine_basis();
  basis.pitch = 0x1p-14;
  const Tolerance t = default_tolerance(basis);
  EXPECT_EQ(t.source, ToleranceSource::Lattice);
  EXPECT_EQ(t.pitches, 32);
  EXPECT_EQ(t.length, 32 * 0x1p-14);
  EXPECT_FALSE(t.coarse_lattice());
}

TEST(DefaultTolerance, FollowsTheFormulaForAnyBasis) {
  tests::LatticeRandom random(1);
  for (int trial = 0; trial < 5000; ++trial) {
    ToleranceBasis basis;
    basis.pitch = std::ldexp(1.0, static_cast<int>(random.between(-60, 60)));
    basis.diagonal = basis.pitch * std::ldexp(1 + random.unit(), static_cast<int>(random.between(18, 24)));
    basis.median_object_diagonal = basis.diagonal * std::ldexp(random.unit(), -static_cast<int>(random.between(0, 12)));
    basis.largest_magnitude = basis.diagonal * std::ldexp(1 + random.unit(), static_cast<int>(random.between(-2, 8)));
    basis.single_precision = random.one_in(2);
    const double ulp = std::ldexp(1.0, std::ilogb(basis.largest_magnitude) - 23);
    const double expected = std::max({32 * basis.pitch, basis.single_precision ? 8 * ulp : 0.0,
                                      std::min(1e-5 * basis.diagonal, 1e-3 * basis.median_object_diagonal)});
    const Tolerance t = default_tolerance(basis);
    ASSERT_LE(t.length, expected);
    ASSERT_GT(t.length, expected - basis.pitch);
    ASSERT_EQ(t.length, static_cast<double>(t.pitches) * basis.pitch);
  }
}

TEST(ParseTolerance, ReadsNumbersWithAndWithoutSuffix) {
  const auto measure = [](std::string_view text) { return parse_tolerance(text).value().measure; };
  const auto value = [](std::string_view text) { return parse_tolerance(text).value().value; };
  EXPECT_EQ(measure("0.5"), ToleranceRequest::Measure::FileUnits);
  EXPECT_EQ(value("0.5"), 0.5);
  EXPECT_EQ(measure("1e-5d"), ToleranceRequest::Measure::Diagonals);
  EXPECT_EQ(value("1e-5d"), 1e-5);
  EXPECT_EQ(measure("0.5mm"), ToleranceRequest::Measure::Metres);
  EXPECT_DOUBLE_EQ(value("0.5mm"), 0.0005);
  EXPECT_DOUBLE_EQ(value("2cm"), 0.02);
  EXPECT_DOUBLE_EQ(value("3m"), 3);
  EXPECT_DOUBLE_EQ(value("1in"), 0.0254);
  EXPECT_DOUBLE_EQ(value("1ft"), 0.3048);
  EXPECT_DOUBLE_EQ(value("1e-3m"), 1e-3);
}

TEST(ParseTolerance, RefusesWhatIsNotAPositiveFiniteLength) {
  for (const std::string_view text : {"",     " ",   "0",   "-1",   "0mm", "nan",  "inf", "1e999",  "mm",   "d",
                                      "1 mm", "1km", "1MM", "1mmm", "1d2", "0.5,", "+1",  "1e-5 d", "0x10", "Auto"}) {
    EXPECT_FALSE(parse_tolerance(text)) << '"' << text << '"';
  }
}

TEST(RequestedTolerance, IsRoundedDownToThePitch) {
  ToleranceBasis basis = fine_basis();
  basis.pitch = 0.25;
  const auto outcome = requested_tolerance({10.9, ToleranceRequest::Measure::FileUnits}, basis, std::nullopt);
  ASSERT_TRUE(outcome.tolerance);
  EXPECT_EQ(outcome.tolerance->length, 10.75);
  EXPECT_EQ(outcome.tolerance->pitches, 43);
  EXPECT_EQ(outcome.tolerance->source, ToleranceSource::Given);
  EXPECT_FALSE(outcome.tolerance->coarse_lattice());
}

TEST(RequestedTolerance, ConvertsDiagonalsAndMetres) {
  ToleranceBasis basis = fine_basis();
  basis.pitch = 0x1p-16;
  const auto diagonals = requested_tolerance({0.01, ToleranceRequest::Measure::Diagonals}, basis, std::nullopt);
  EXPECT_NEAR(diagonals.tolerance.value().length, 1, 0x1p-16);
  const ToleranceRequest half_millimetre{0.0005, ToleranceRequest::Measure::Metres};
  EXPECT_NEAR(requested_tolerance(half_millimetre, basis, 0.001).tolerance.value().length, 0.5, 0x1p-16);
  const auto without_unit = requested_tolerance(half_millimetre, basis, std::nullopt);
  EXPECT_FALSE(without_unit.tolerance);
  EXPECT_NE(without_unit.problem.find("--units"), std::string::npos);
}

TEST(RequestedTolerance, BelowEightPitchesNamesTheSmallest) {
  ToleranceBasis basis = fine_basis();
  basis.pitch = 0.125;
  const auto refused = requested_tolerance({0.999, ToleranceRequest::Measure::FileUnits}, basis, std::nullopt);
  EXPECT_FALSE(refused.tolerance);
  EXPECT_NE(refused.problem.find("smallest possible is 1 "), std::string::npos) << refused.problem;
  const auto least = requested_tolerance({1, ToleranceRequest::Measure::FileUnits}, basis, std::nullopt);
  ASSERT_TRUE(least.tolerance);
  EXPECT_EQ(least.tolerance->pitches, 8);
  EXPECT_TRUE(least.tolerance->coarse_lattice()) << "8 to 32 pitches: allowed with a warning";
}

TEST(ToleranceNames, AreTheWordsOfTheReport) {
  EXPECT_EQ(name(ToleranceSource::Default), "default");
  EXPECT_EQ(name(ToleranceSource::SinglePrecision), "single-precision");
  EXPECT_EQ(name(ToleranceSource::Lattice), "lattice");
  EXPECT_EQ(name(ToleranceSource::Given), "given");
  EXPECT_EQ(name(ToleranceSource::Recorded), "recorded");
  EXPECT_EQ(name(ToleranceSource::Declared), "declared");
}

TEST(RecordedTolerance, GoesBeforeTheDefaultOnly) {
  ToleranceBasis basis = fine_basis();
  basis.pitch = 0x1p-10;
  basis.recorded = 0.125;
  const Tolerance t = default_tolerance(basis);
  EXPECT_EQ(t.source, ToleranceSource::Recorded);
  EXPECT_EQ(t.length, 0.125);
  EXPECT_EQ(t.pitches, 128);
  EXPECT_EQ(t.diagonal, 100);
  const auto asked = requested_tolerance({0.5, ToleranceRequest::Measure::FileUnits}, basis, std::nullopt);
  EXPECT_EQ(asked.tolerance.value().length, 0.5);
  EXPECT_EQ(asked.tolerance.value().source, ToleranceSource::Given);
}

TEST(DeclaredTolerance, GoesBeforeTheDefaultWhereTheLatticeAllowsIt) {
  ToleranceBasis basis = fine_basis();
  basis.pitch = 0x1p-10;
  basis.declared = 0.125;
  EXPECT_EQ(default_tolerance(basis).source, ToleranceSource::Declared);
  EXPECT_EQ(default_tolerance(basis).length, 0.125);
  basis.declared = 0x1p-6;  // 16 pitches
  EXPECT_NE(default_tolerance(basis).source, ToleranceSource::Declared);
  basis.declared = 50;
  EXPECT_NE(default_tolerance(basis).source, ToleranceSource::Declared);
  basis.declared = 0.125;
  basis.recorded = 0.25;
  EXPECT_EQ(default_tolerance(basis).source, ToleranceSource::Recorded);
}

TEST(RecordedTolerance, IsOfUseFromEightPitchesToAHundredthOfTheDiagonal) {
  EXPECT_TRUE(is_usable_record(2, 0.25, 200));
  EXPECT_FALSE(is_usable_record(1.999, 0.25, 200));
  EXPECT_FALSE(is_usable_record(2.001, 0.25, 200));
  for (const double length : {0.0, -2.0, std::nan(""), HUGE_VAL}) EXPECT_FALSE(is_usable_record(length, 0.25, 200));
}

}  // namespace
}  // namespace rad::geom
