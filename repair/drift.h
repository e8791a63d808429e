// How far the surfaces of a conformed soup are from where they were: what the ladder holds against the promise that no
// face loses its surface and nothing comes up elsewhere.
#pragma once

#include "repair/conform.h"

namespace rad::repair {

/// Every face thicker than 2 T still has a surface within this many T, and every surface a face.
inline constexpr double kFarthestSurface = 8;

/// Measures the triangles of `conformed` against those that `before` had, and the other way round, where points were
/// merged or triangles moved to other planes: nothing else draws surfaces that far. `tolerance` is T in pitches.
Drift drift_of(const Conformed& conformed, const Soup& before, std::int64_t tolerance);

}  // namespace rad::repair
