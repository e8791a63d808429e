// --tolerance auto: T between the noise of a model and its features, where the two can be told apart.
#pragma once

#include <vector>

#include "geom/tolerance.h"

namespace rad::geom {

/// Distances up to this share of the diagonal are looked at.
inline constexpr double kAutoReach = 1e-2;
/// T is at most this share of the diagonal.
inline constexpr double kLargestAutoShare = 1e-4;
/// The gap is at least this wide, in decades: T in its middle is then three times all noise and a third of all
/// features.
inline constexpr double kLeastAutoGap = 1;
/// Features are at least this many T apart: strips of 2 T stay open (RL107).
inline constexpr double kAutoFeatures = 2;

/// The recorded T where there is one. Else T in the middle, on a scale of logarithms, of the widest gap in `distances`
/// (file units, any order: from vertices to their nearest vertices and edges) in which a T of at least 32 pitches, 8
/// ulp for float formats, and at most kLargestAutoShare of the diagonal can lie. Where there is none, the default T,
/// with Tolerance::choice saying so.
Tolerance auto_tolerance(const ToleranceBasis& basis, std::vector<double> distances);

}  // namespace rad::geom
