// Leaving out faces that nothing can be made of.
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace rad::scene {

/// Takes out the faces with a corner that is not finite (RL003); vertices that are not finite move to one that is, so
/// that a file can hold them. Ids of vertices stay, those of faces close up. Returns the faces taken out.
std::size_t drop_bad_faces(Scene& scene);

}  // namespace rad::scene
