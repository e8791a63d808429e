#include "solve/importance.h"

#include <algorithm>
#include <cmath>

namespace rad::solve {
namespace {

constexpr double kHalfCoveredError = 0.4;  ///< of one ray, measured; for n strata it falls with n^(-3/4)

}  // namespace

double Importance::of(mesh::PatchId from, mesh::PatchId to) const {
  double most = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double received = irradiance[to][channel];
    if (received > 0) most = std::max(most, radiosity[from][channel] / received);
  }
  return most;
}

int Importance::level_for(double share) const {
  const double excess = kHalfCoveredError * share / noise;
  if (!(excess > 1)) return 0;
  // n = excess^(4/3), level = log4 n.
  return std::min(kDeepestStrata, static_cast<int>(std::ceil(std::log2(excess) * (2.0 / 3))));
}

}  // namespace rad::solve
