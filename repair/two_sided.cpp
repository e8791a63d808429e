#include "repair/two_sided.h"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <vector>

#include "scene/corner_rows.h"
#include "scene/twins.h"

namespace rad::repair {
namespace {

using scene::Face;
using scene::Loop;
using scene::ObjectId;
using scene::Scene;

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

/// Which of the names are matched; notes the patterns that matched something.
std::vector<bool> matched(std::span<const std::string> patterns, const std::vector<std::string>& names,
                          std::vector<bool>& used) {
  std::vector<bool> any(names.size(), false);
  for (std::size_t p = 0; p < patterns.size(); ++p) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!matches(patterns[p], names[i])) continue;
      any[i] = true;
      used[p] = true;
    }
  }
  return any;
}

class Doubler {
 public:
  Doubler(Scene scene, std::span<const std::string> patterns)
      : scene_(std::move(scene)), patterns_(patterns), normal_rows_(scene_.attributes.normals.table) {}

  Doubled run() {
    std::vector<std::string> materials;
    for (const scene::Material& material : scene_.materials) materials.push_back(material.name);
    std::vector<bool> used(patterns_.size(), false);
    const std::vector<bool> objects = matched(patterns_, scene_.objects, used);
    const std::vector<bool> painted = matched(patterns_, materials, used);
    const auto unused = std::ranges::find(used, false);
    if (unused != used.end()) return {std::move(scene_), 0, patterns_[static_cast<std::size_t>(unused - used.begin())]};
    const std::vector<bool> done = objects_with_twins();
    const std::size_t count = scene_.faces.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Face& face = scene_.faces[i];
      if (!done[face.object] && (objects[face.object] || painted[face.material])) add_twin(i);
    }
    const std::size_t twins = scene_.faces.size() - count;
    return {std::move(scene_), twins, {}};
  }

 private:
  [[nodiscard]] std::vector<bool> objects_with_twins() const {
    std::vector<bool> done(scene_.objects.size(), false);
    for (ObjectId id = 0; id < scene_.objects.size(); ++id) {
      const std::string twin = scene::twin_name(scene_.objects[id]);
      done[id] =
          scene::is_twin_name(scene_.objects[id]) || std::ranges::find(scene_.objects, twin) != scene_.objects.end();
    }
    return done;
  }

  ObjectId twin_of(ObjectId object) {
    const auto [entry, fresh] = twins_.emplace(object, static_cast<ObjectId>(scene_.objects.size()));
    if (fresh) scene_.objects.push_back(scene::twin_name(scene_.objects[object]));
    return entry->second;
  }

  void add_twin(std::size_t id) {
    Face face = scene_.faces[id];
    const std::uint32_t first = face.first_loop;
    face.first_loop = static_cast<std::uint32_t>(scene_.loops.size());
    face.object = twin_of(face.object);
    for (std::uint32_t i = 0; i < face.loop_count; ++i) {
      const Loop loop = scene_.loops[first + i];
      scene_.loops.push_back({static_cast<std::uint32_t>(scene_.corners.size()), loop.count});
      for (std::uint32_t k = loop.count; k-- > 0;) add_corner(loop.first + k);
    }
    if (!scene_.smoothing_groups.empty()) scene_.smoothing_groups.push_back(scene_.smoothing_groups[id]);
    scene_.faces.push_back(face);
  }

  // With its texture coordinates, and the normal of the other side.
  void add_corner(std::size_t like) {
    scene_.corners.push_back(scene_.corners[like]);
    auto& texture = scene_.attributes.texture_coordinates;
    if (!texture.empty()) texture.row_of_corner.push_back(texture.row(like));
    auto& normals = scene_.attributes.normals;
    if (normals.empty()) return;
    const scene::RowId row = normals.row(like);
    normals.row_of_corner.push_back(row == scene::kNoRow ? row : normal_rows_.row(-normals.table[row]));
  }

  Scene scene_;
  std::span<const std::string> patterns_;
  scene::CornerRows<geom::dvec3> normal_rows_;
  std::map<ObjectId, ObjectId> twins_;
};

}  // namespace

Doubled with_twins(Scene scene, std::span<const std::string> patterns) {
  return Doubler(std::move(scene), patterns).run();
}

}  // namespace rad::repair
