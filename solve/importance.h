// How much of what a patch receives another one sends: what the effort for a pair is measured by.
#pragma once

#include <vector>

#include "geom/vec.h"
#include "mesh/radiosity_mesh.h"

namespace rad::solve {

using geom::dvec3;

/// Strata of a radiator are 4^level; no radiator gets more than 4^kDeepestStrata.
constexpr int kDeepestStrata = 4;

/// An estimate of the solution, patch by patch.
struct Importance {
  std::vector<dvec3> radiosity;   ///< as a radiator, W/m²
  std::vector<dvec3> irradiance;  ///< as a receiver, W/m²; above 0 wherever light gets in the end
  double noise = 0;               ///< error that one pair may make, as a share of the irradiance; above 0

  /// Radiosity of `from` over irradiance of `to`, the largest over the channels: times a form factor the share of all
  /// that `to` receives that comes from `from`.
  [[nodiscard]] double of(mesh::PatchId from, mesh::PatchId to) const;
  /// The least level at which a half covered radiator that sends this share of the irradiance makes no more than the
  /// noise. One jittered ray in each of n strata has a standard error of 0.4 n^(-3/4).
  [[nodiscard]] int level_for(double share) const;
  /// The level to look with first, before those whose strata disagree are looked at with this one. Few strata that
  /// agree by chance would bias the result: where a tenth of a radiator is seen, of four rays all are blocked in two
  /// cases of three.
  [[nodiscard]] static int first_level(int level) { return level <= 2 ? level : level - 1; }
};

}  // namespace rad::solve
