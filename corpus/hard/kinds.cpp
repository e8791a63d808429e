#include "corpus/hard/kinds.h"

#include <algorithm>

namespace rad::corpus {
namespace {

constexpr double kTolerance = 1e-2, kSmallTolerance = 1e-4;
// T = 1e-2 is ten of these.
constexpr double kCoarsePitch = 0x1p-10;
// Single precision has 2^-11 here: 20 steps in T = 1e-2, and less than one in 1e-4.
constexpr double kFar = 4096;

// Bits of the seed that say how a scene is placed; see hard_scene().
enum class Placement { AsDrawn, CoarseLattice, SmallTolerance };
Placement placement(std::uint64_t seed) {
  const std::uint64_t way = seed / 16 % 4;
  return way == 2 ? Placement::CoarseLattice : way == 3 ? Placement::SmallTolerance : Placement::AsDrawn;
}
bool is_mixed(std::uint64_t seed) { return seed % 4 == 3; }
bool is_float32(std::uint64_t seed) { return seed / 4 % 4 >= 2; }
bool is_far(std::uint64_t seed) { return seed / 4 % 4 == 3 && placement(seed) == Placement::AsDrawn; }

void round_to_float(scene::Scene& scene) {
  for (dvec3& p : scene.vertices) {
    p = dvec3(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  }
  scene.single_precision = true;
}

}  // namespace

std::span<const HardKind> hard_kinds() {
  static const std::vector<HardKind> all = [] {
    std::vector<HardKind> list;
    for (const auto part :
         {coincident_kinds(), standing_kinds(), slanted_kinds(), thin_kinds(), outlined_kinds(), crowded_kinds()}) {
      list.insert(list.end(), part.begin(), part.end());
    }
    return list;
  }();
  return all;
}

const HardKind* hard_kind(std::string_view name) {
  const auto found = std::ranges::find(hard_kinds(), name, &HardKind::name);
  return found == hard_kinds().end() ? nullptr : &*found;
}

HardScene hard_scene(const HardKind& kind, std::uint64_t seed, int size) {
  const Placement placed = placement(seed);
  HardScene result;
  result.tolerance = placed == Placement::SmallTolerance ? kSmallTolerance : kTolerance;
  HardSketch sketch(seed, result.tolerance, size);
  kind.draw(sketch);
  if (is_mixed(seed)) {
    const HardKind& other = hard_kinds()[sketch.random().index(hard_kinds().size())];
    other.draw(sketch);
    result.variant = "+" + std::string(other.name);
  }
  if (is_far(seed)) {
    sketch.transform(0, glm::dmat3(1), {kFar, -kFar, kFar / 2});
    result.variant += " far";
  }
  result.scene = sketch.scene();
  if (is_float32(seed)) {
    round_to_float(result.scene);
    result.variant += " float32";
  }
  if (placed == Placement::CoarseLattice) {
    result.scene.recorded = scene::RecordedLattice{{kCoarsePitch, {0, 0, 0}}, result.tolerance};
    result.variant += " coarse-lattice";
  }
  if (placed == Placement::SmallTolerance) result.variant += " T=1e-4";
  return result;
}

}  // namespace rad::corpus
