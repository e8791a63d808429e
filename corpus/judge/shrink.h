// Making a failing scene small: fewer faces, then rounder coordinates, while it still fails.
#pragma once

#include <functional>
#include <span>

#include "scene/scene.h"

namespace rad::corpus {

/// Whether the scene still shows the fault.
using StillFails = std::function<bool(const scene::Scene&)>;

/// `scene` must fail. Drops faces by delta debugging (Zeller 1999) until none can be dropped alone; then rounds
/// coordinates, all and one vertex after the other, to as few decimals as leave the fault. Deterministic.
scene::Scene shrunken(const scene::Scene& scene, const StillFails& still_fails);

/// The faces of `kept`, in order, and the vertices that they use; names and records stay.
scene::Scene with_faces(const scene::Scene& scene, std::span<const scene::FaceId> kept);

}  // namespace rad::corpus
