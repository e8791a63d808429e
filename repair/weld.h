// Welding: every group of points closer than the weld distance becomes one, in no order but that of space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "repair/point_grid.h"

namespace rad::repair {

/// For each point the index of the point that takes its place; points that stay represent themselves. Representatives
/// are more than kWeldRatio · `tolerance` apart and no point moves farther than tolerance / 2 + that. `tolerance` in
/// pitches. Two phases: mutually nearest points contract while no member moves more than tolerance / 2, which repairs
/// noise first; then a maximal independent set in the order of multiplicity and place takes in the rest in one hop, so
/// that a chain of near points never collapses. The positions chosen depend on the set of points only. `mask`: per
/// point, whether it is looked at; empty where all are.
std::vector<std::uint32_t> weld(std::span<const LatticePoint> points, double tolerance,
                                std::span<const std::uint8_t> mask = {});

}  // namespace rad::repair
