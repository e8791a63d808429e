#include "repair/texture_regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "scene/texture_map.h"

namespace rad::repair {
namespace {

using scene::FaceId;
using scene::TextureMap;

class Regions {
 public:
  Regions(const PlanarTriangles& set, const scene::Scene& scene,
          std::span<const std::array<std::uint32_t, 2>> neighbours, double tolerance)
      : set_(set), scene_(scene), tolerance_(tolerance), region_(scene.faces.size(), kNone) {
    for (const auto& [a, b] : neighbours) {
      const FaceId from = source(a), to = source(b);
      if (from == to || !mapped(from) || !mapped(to)) continue;
      links_.push_back({from, to});
      links_.push_back({to, from});
    }
    std::sort(links_.begin(), links_.end());
    links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
  }

  std::vector<std::uint32_t> run() {
    for (const FaceId leader : leaders()) {
      if (region_[leader] == kNone) grow(leader);
    }
    std::vector<std::uint32_t> of_triangles;
    of_triangles.reserve(set_.members.size());
    for (const auto& member : set_.members) of_triangles.push_back(mapped(member.source) ? region_[member.source] : 0);
    return of_triangles;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  [[nodiscard]] FaceId source(std::uint32_t triangle) const { return set_.members[triangle].source; }
  [[nodiscard]] bool mapped(FaceId face) const { return has_texture_coordinates(scene_, scene_.faces[face]); }

  // The sources with texture coordinates, larger maps first; those that have no map, being on a line, last.
  std::vector<FaceId> leaders() {
    std::vector<FaceId> faces;
    for (const auto& member : set_.members) faces.push_back(member.source);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::erase_if(faces, [&](FaceId face) { return !mapped(face); });
    for (const FaceId face : faces) maps_.emplace(face, TextureMap::of(scene_, scene_.faces[face]));
    std::stable_sort(faces.begin(), faces.end(), [&](FaceId a, FaceId b) {
      const auto &map_a = maps_.at(a), &map_b = maps_.at(b);
      if (!map_a || !map_b) return map_a.has_value() && !map_b.has_value();
      return map_a->leads(*map_b);
    });
    return faces;
  }

  void grow(FaceId leader) {
    const std::uint32_t region = ++count_;
    region_[leader] = region;
    const auto& map = maps_.at(leader);
    if (!map || !fits(*map, leader)) return;
    std::vector<FaceId> front{leader};
    while (!front.empty()) {
      const FaceId face = front.back();
      front.pop_back();
      for (const auto& [from, to] : std::ranges::equal_range(links_, face, {}, [](const auto& l) { return l[0]; })) {
        if (region_[to] != kNone || !fits(*map, to)) continue;
        region_[to] = region;
        front.push_back(to);
      }
    }
  }

  [[nodiscard]] bool fits(const TextureMap& map, FaceId face) const {
    return map.fits(scene_, scene_.faces[face], tolerance_);
  }

  const PlanarTriangles& set_;
  const scene::Scene& scene_;
  double tolerance_;
  std::vector<std::array<FaceId, 2>> links_;  ///< both ways, ascending
  std::map<FaceId, std::optional<TextureMap>> maps_;
  std::vector<std::uint32_t> region_;  ///< per face
  std::uint32_t count_ = 0;
};

}  // namespace

std::vector<std::uint32_t> texture_regions(const PlanarTriangles& triangles, const scene::Scene& scene,
                                           std::span<const std::array<std::uint32_t, 2>> neighbours, double tolerance) {
  if (scene.attributes.texture_coordinates.empty()) return {};
  return Regions(triangles, scene, neighbours, tolerance).run();
}

}  // namespace rad::repair
