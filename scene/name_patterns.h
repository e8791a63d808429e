// Faces chosen by the names of their objects and materials.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace rad::scene {

/// Patterns as in a shell: `*`, `?` and `[a-z]`; `*` stands for slashes too. A face is chosen where its object fits one
/// of `objects` and its material one of `materials`; an empty list asks for nothing.
struct NamePatterns {
  std::vector<std::string> objects;
  std::vector<std::string> materials;

  [[nodiscard]] bool empty() const { return objects.empty() && materials.empty(); }
};

/// The faces of one scene that patterns choose; every name is looked at once.
class NamedFaces {
 public:
  NamedFaces(const NamePatterns& patterns, const Scene& scene);

  [[nodiscard]] bool has(const Face& face) const { return objects_[face.object] && materials_[face.material]; }

 private:
  std::vector<bool> objects_;    ///< per object
  std::vector<bool> materials_;  ///< per material
};

}  // namespace rad::scene
