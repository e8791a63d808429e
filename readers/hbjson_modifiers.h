// Modifiers of HBJSON, which are materials of Radiance, and the sets that hand them out by the type of a face.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "readers/json_view.h"
#include "scene/scene_builder.h"

namespace rad::readers::hbjson {

/// What a face is to the sets of modifiers.
struct FaceSort {
  std::string_view set;     ///< "wall_set", "aperture_set"…
  std::string_view member;  ///< "exterior_modifier", "window_modifier"…
};

class Modifiers {
 public:
  /// Reads properties.radiance of the model.
  Modifiers(const JsonView& model, scene::SceneBuilder& builder, scene::ReadIssues& issues);

  /// The material of a face: its own modifier, else that of the set of its room, else that of the model's set, else
  /// one named `fallback` without reflectance.
  scene::MaterialId material_of(const JsonView& face, const JsonView& room, const FaceSort& sort,
                                std::string_view fallback);

 private:
  void add(const JsonView& modifier);
  void add_set(const JsonView& set);
  [[nodiscard]] std::string of_set(const std::string& set, const FaceSort& sort) const;

  scene::SceneBuilder& builder_;
  scene::ReadIssues& issues_;
  std::map<std::string, scene::MaterialId, std::less<>> materials_;
  std::map<std::string, JsonView, std::less<>> sets_;
  std::string global_set_;
};

}  // namespace rad::readers::hbjson
