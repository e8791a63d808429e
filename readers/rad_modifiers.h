// Materials, patterns and aliases of a Radiance scene description, by name.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "readers/radiance_material.h"
#include "readers/unique_names.h"
#include "scene/read_issue.h"
#include "scene/scene_builder.h"

namespace rad::readers::radiance {

inline constexpr std::size_t kLongestName = 255;

struct Primitive {
  std::string_view modifier, type, identifier;
  std::vector<std::string_view> strings;
  std::vector<double> reals;
  std::uint64_t line = 0;
};

/// What a modifier name stands for from its definition on.
struct Definition {
  scene::MaterialId material = 0;
  bool is_antimatter = false;
};

/// Whether this type names no surface and no material, but what changes how materials look.
bool is_pattern(std::string_view type);

class Modifiers {
 public:
  Modifiers(scene::SceneBuilder& builder, scene::ReadIssues& issues);

  /// Takes an alias, a material or a pattern. A name that is defined again stands for something else from then on.
  /// What a diffuse material cannot show is counted.
  void define(const Primitive& primitive, const scene::IssuePlace& place);

  /// What a name stands for; a name without a definition is a MissingResource and a material that states nothing.
  Definition find(std::string_view name, const scene::IssuePlace& place);

 private:
  [[nodiscard]] bool is_defined_so(const std::string& name, const Optics& optics) const;

  scene::SceneBuilder& builder_;
  scene::ReadIssues& issues_;
  std::map<std::string, Definition, std::less<>> definitions_;
  UniqueNames names_;
};

}  // namespace rad::readers::radiance
