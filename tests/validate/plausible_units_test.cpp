#include "validate/plausible_units.h"

#include <gtest/gtest.h>

#include "corpus/generate/models.h"

namespace rad::validate {
namespace {

SizeEvidence with_doors(double diagonal, double height) { return {diagonal, height, "doors", 2.3, 1.3}; }

TEST(PlausibleUnits, DoorsDecide) {
  const SizeEvidence evidence = with_doors(9000, 2300);
  const UnitGuesses guesses = plausible_units(evidence);
  EXPECT_EQ(guesses.best.unit, "mm");
  EXPECT_EQ(guesses.runner_up.unit, "cm");
  EXPECT_EQ(words_of(evidence, guesses), "doors would be 2.3 m if units were mm; runner-up: cm (23 m)");
}

TEST(PlausibleUnits, TheDiagonalAlone) {
  for (const auto& [diagonal, unit] : {std::pair{12.0, "m"}, {1200.0, "cm"}, {12000.0, "mm"}}) {
    EXPECT_EQ(plausible_units({diagonal}).best.unit, unit);
  }
  const SizeEvidence evidence{14};
  EXPECT_EQ(words_of(evidence, plausible_units(evidence)),
            "the model would be 14 m across if units were m; runner-up: ft (4.3 m)");
}

TEST(PlausibleUnits, FeetAndMetresAreToldApartByThings) {
  EXPECT_EQ(plausible_units(with_doors(40, 7.5)).best.unit, "ft");
  EXPECT_EQ(plausible_units(with_doors(40, 2.2)).best.unit, "m");
}

TEST(PlausibleUnits, NamesAreReadWordByWord) {
  for (const auto& [name, kind] : {std::pair{"Door_01", "doors"},
                                   {"FrontDoor", "doors"},
                                   {"kitchen doors", "doors"},
                                   {"outdoor", ""},
                                   {"Doorknob", ""},
                                   {"vegetable", ""},
                                   {"TABLE 3", "tables"}}) {
    scene::Scene scene = corpus::clean_terrain(4);
    scene.objects.assign(scene.objects.size(), name);
    std::string refusal;
    const auto context = build_context(scene, {}, std::nullopt, refusal);
    EXPECT_EQ(size_evidence(*context).typical_name, kind) << name;
  }
}

TEST(PlausibleUnits, LengthsAreReadable) {
  EXPECT_EQ(metric_length(1234), "1.2 km");
  EXPECT_EQ(metric_length(123.4), "123 m");
  EXPECT_EQ(metric_length(2.13), "2.1 m");
  EXPECT_EQ(metric_length(0.35), "35 cm");
  EXPECT_EQ(metric_length(0.0035), "3.5 mm");
}

}  // namespace
}  // namespace rad::validate
