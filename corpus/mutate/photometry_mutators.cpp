// Defects of files of luminous intensities. The clean ones are of lamps whose intensity goes with a power of the
// cosine, so that their flux is known without adding anything up.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>

#include "corpus/mutate/mutator.h"

namespace rad::corpus {
namespace {

constexpr int kAngleStep = 5, kPlaneStep = 45, kPlanes = 360 / kPlaneStep;

/// What is written of a lamp, before it is put into lines.
struct Lamp {
  std::string tilt = "TILT=NONE";
  double lumens = 1000;
  double multiplier = 1;
  double share = 1;  ///< of the lumens, leaves the luminaire
  int symmetry = 0;
  std::vector<int> angles, planes;
  std::vector<double> intensity;  ///< plane by plane
};

// A lamp of 1000 lm, of which two thirds or more leave the luminaire.
Lamp lamp(Random& random, bool closed) {
  Lamp it;
  const double power = random.real(1, 6);
  it.share = random.real(0.66, 0.98);
  const double strongest = it.share * it.lumens * (power + 1) / (2 * std::numbers::pi);
  for (int angle = 0; angle <= 90; angle += kAngleStep) it.angles.push_back(angle);
  for (int plane = 0; plane < kPlanes + (closed ? 1 : 0); ++plane) it.planes.push_back(plane * kPlaneStep);
  for (std::size_t plane = 0; plane < it.planes.size(); ++plane) {
    for (const int angle : it.angles) {
      it.intensity.push_back(strongest * std::pow(std::max(0.0, std::cos(angle * std::numbers::pi / 180)), power));
    }
  }
  return it;
}

std::string ies(const Lamp& lamp) {
  return fmt::format("IESNA:LM-63-2002\n[MANUFAC] planted\n{}\n1 {} {} {} {} 1 2 0.1 0.1 0\n1 1 20\n{}\n{}\n{:.4f}\n",
                     lamp.tilt, lamp.lumens, lamp.multiplier, lamp.angles.size(), lamp.planes.size(),
                     fmt::join(lamp.angles, " "), fmt::join(lamp.planes, " "), fmt::join(lamp.intensity, "\n"));
}

// The light output ratio is a percentage.
std::string ldt(const Lamp& lamp, double ratio) {
  std::string text = fmt::format("planted\n1\n{}\n{}\n{}\n{}\n{}\n", lamp.symmetry, kPlanes, kPlaneStep,
                                 lamp.angles.size(), kAngleStep);
  for (int i = 0; i < 14; ++i) text += "0\n";
  text += fmt::format("100\n{:.2f}\n1\n0\n1\n1\nlamp\n{}\n3000\n80\n20\n", ratio, lamp.lumens);
  for (int i = 0; i < 10; ++i) text += "0.5\n";
  return text + fmt::format("{}\n{}\n{:.4f}\n", fmt::join(lamp.planes, "\n"), fmt::join(lamp.angles, "\n"),
                            fmt::join(lamp.intensity, "\n"));
}

std::string sound_ies(Random& random) { return ies(lamp(random, true)); }

std::string sound_ldt(Random& random) {
  const Lamp it = lamp(random, false);
  return ldt(it, 100 * it.share);
}

std::string number_missing(Random& random) {
  Lamp it = lamp(random, true);
  it.intensity.erase(it.intensity.begin() + static_cast<std::ptrdiff_t>(random.index(it.intensity.size())));
  return ies(it);
}

std::string angles_swapped(Random& random) {
  Lamp it = lamp(random, true);
  const std::size_t at = random.index(it.angles.size() - 1);
  std::swap(it.angles[at], it.angles[at + 1]);
  return ies(it);
}

std::string too_bright(Random& random) {
  Lamp it = lamp(random, true);
  it.multiplier = random.real(1.7, 1000);
  return ies(it);
}

std::string other_ratio(Random& random) {
  const Lamp it = lamp(random, false);
  return ldt(it, 100 * it.share * (random.index(2) == 0 ? 0.8 : 1.25));
}

std::string turn_not_closed(Random& random) { return ies(lamp(random, false)); }

std::string other_symmetry(Random& random) {
  Lamp it = lamp(random, false);
  it.symmetry = 1 + static_cast<int>(random.index(4));
  return ldt(it, 100 * it.share);
}

std::string tilted(Random& random) {
  Lamp it = lamp(random, true);
  it.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.95 0.9";
  return ies(it);
}

}  // namespace

std::span<const PhotometryMutator> photometry_mutators() {
  static constexpr std::array<PhotometryMutator, 7> kMutators{{
      {"intensity missing", "RL430", ".ies", sound_ies, number_missing},
      {"angles that changed places", "RL430", ".ies", sound_ies, angles_swapped},
      {"more light than the lamp gives", "RL431", ".ies", sound_ies, too_bright},
      {"another light output ratio", "RL431", ".ldt", sound_ldt, other_ratio},
      {"last plane missing", "RL432", ".ies", sound_ies, turn_not_closed},
      {"another symmetry", "RL433", ".ldt", sound_ldt, other_symmetry},
      {"lamp that tilts", "RL434", ".ies", sound_ies, tilted},
  }};
  return kMutators;
}

}  // namespace rad::corpus
