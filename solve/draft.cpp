#include "solve/draft.h"

#include <algorithm>
#include <glm/common.hpp>

#include "solve/shooting.h"

namespace rad::solve {
namespace {

constexpr double kDraftNoise = 0.02;
constexpr double kDraftUnshot = 0.1;  ///< share of the emitted power
/// Pairs of patches that a draft may look at: a few seconds of one core.
constexpr std::size_t kDraftPairs = 20'000'000;
/// Share of the mean irradiance below which it does not matter how exact it is.
constexpr double kDarkest = 1e-3;

void limit_darkness(Importance& importance, const Radiators& radiators) {
  double area = 0;
  dvec3 mean{0, 0, 0};
  for (std::size_t patch = 0; patch < radiators.patch.size(); ++patch) {
    area += radiators.patch[patch].area;
    mean += importance.irradiance[patch] * radiators.patch[patch].area;
  }
  if (!(area > 0)) return;
  for (dvec3& irradiance : importance.irradiance) irradiance = glm::max(irradiance, mean * (kDarkest / area));
}

}  // namespace

Importance draft_importance(const CouplingSource& source, std::span<const scene::Material> materials) {
  Importance importance;
  CouplingSource draft{source.mesh,       source.radiators, source.receivers, source.samples,
                       source.visibility, importance,       source.lift,      true};
  CouplingStore couplings(draft, 0);
  Shooting shooting(source.mesh, source.radiators, source.samples, materials, couplings);
  importance = shooting.importance();
  importance.noise = kDraftNoise;
  const std::size_t most = kDraftPairs / std::max<std::size_t>(1, source.mesh.patches.size()) + 1;
  while (shooting.unshot_share() > kDraftUnshot && shooting.shots() < most) shooting.shoot(most - shooting.shots());
  Importance result = shooting.importance();
  result.noise = kDraftNoise;
  limit_darkness(result, source.radiators);
  return result;
}

}  // namespace rad::solve
