#include "geom/auto_tolerance.h"

#include <algorithm>
#include <cmath>

namespace rad::geom {
namespace {

struct Gap {
  double low = 0;
  double high = 0;
  double middle = 0;  ///< within what T may be
};

// The widest gap that T fits into; of equal ones the lowest, which loses the least.
std::optional<Gap> widest_gap(const std::vector<double>& ascending, double least, double most) {
  std::optional<Gap> widest;
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    const Gap gap{ascending[i - 1], ascending[i], std::clamp(std::sqrt(ascending[i - 1] * ascending[i]), least, most)};
    const bool fits = gap.middle >= gap.low && kAutoFeatures * gap.middle <= gap.high;
    if (!fits || std::log10(gap.high / gap.low) < kLeastAutoGap) continue;
    if (!widest || gap.high / gap.low > widest->high / widest->low) widest = gap;
  }
  return widest;
}

}  // namespace

Tolerance auto_tolerance(const ToleranceBasis& basis, std::vector<double> distances) {
  Tolerance usual = default_tolerance(basis);
  if (usual.source == ToleranceSource::Recorded) return usual;
  std::erase_if(distances, [&](double d) { return !(d > 0) || d > kAutoReach * basis.diagonal; });
  std::sort(distances.begin(), distances.end());
  const double least = least_tolerance(basis), most = kLargestAutoShare * basis.diagonal;
  const auto gap = least < most ? widest_gap(distances, least, most) : std::nullopt;
  if (!gap) {
    usual.choice = AutoChoice{.usual = usual.length};
    return usual;
  }
  Tolerance chosen = on_lattice(gap->middle, basis, ToleranceSource::Auto);
  const auto apart = std::ranges::upper_bound(distances, kWeldRatio * usual.length);
  const auto joined = std::ranges::upper_bound(distances, kWeldRatio * chosen.length);
  chosen.choice = AutoChoice{std::log10(gap->high / gap->low), gap->low, gap->high, usual.length,
                             static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(0, joined - apart))};
  return chosen;
}

}  // namespace rad::geom
