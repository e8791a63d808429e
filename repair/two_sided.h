// Twins on request (--two-sided): a face that looks the other way in the same place, so that a sheet has two fronts.
#pragma once

#include <span>
#include <string>

#include "scene/scene.h"

namespace rad::repair {

struct Doubled {
  scene::Scene scene;
  std::size_t twins = 0;
  std::string unmatched;  ///< the first pattern that no object and no material matches; then nothing was done
};

/// The scene with a twin for every face whose object or material matches one of the patterns (`*`, `?` and `[…]` as in
/// a shell). A twin has the loops of its face backward, its material and texture coordinates, its
/// normals negated, and the object twin_name(). Twins get none, nor
/// do faces of objects that have twins already, so that doing it twice is doing it once.
Doubled with_twins(scene::Scene scene, std::span<const std::string> patterns);

}  // namespace rad::repair
