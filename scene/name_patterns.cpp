#include "scene/name_patterns.h"

#include <fnmatch.h>

#include <algorithm>

namespace rad::scene {

namespace {

bool fits(const std::vector<std::string>& patterns, const std::string& name) {
  return patterns.empty() || std::ranges::any_of(patterns, [&](const std::string& pattern) {
           return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
         });
}

}  // namespace

NamedFaces::NamedFaces(const NamePatterns& patterns, const Scene& scene) {
  for (const std::string& name : scene.objects) objects_.push_back(fits(patterns.objects, name));
  for (const Material& material : scene.materials) materials_.push_back(fits(patterns.materials, material.name));
}

}  // namespace rad::scene
