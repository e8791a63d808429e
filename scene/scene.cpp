#include "scene/scene.h"

#include <utility>

namespace rad::scene {

Scene empty_scene(std::string path, std::string format) {
  Scene scene;
  scene.path = std::move(path);
  scene.format = std::move(format);
  scene.materials.emplace_back();
  scene.objects.emplace_back();
  scene.groups.emplace_back();
  return scene;
}

}  // namespace rad::scene
