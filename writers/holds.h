// What a format has a place for, and what of a scene it would lose.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace rad::writers {

enum class Corners : std::uint8_t { Three, Four, Any };

/// What a format keeps of a scene.
struct Holds {
  Corners corners = Corners::Any;  ///< of a face
  bool holes = false;              ///< as holes; else the outline goes to them and back
  bool objects = false;            ///< their names
  bool groups = false;
  bool materials = false;  ///< their names
  bool reflectance = false;
  bool emission = false;
  bool reflecting_lights = false;  ///< what emits may reflect as well
  bool images = false;
  bool unit = false;
  bool doubles = false;  ///< coordinates in double precision
};

/// What a scene has and the format does not hold, one clause each with its number: "names of 3 materials".
std::vector<std::string> losses_of(const scene::Scene& scene, const Holds& holds);

}  // namespace rad::writers
