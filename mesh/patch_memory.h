// Patches of faces kept while a model is meshed again and again with few changes: a face with the outline that it had
// before has the patches that it had.
#pragma once

#include <bit>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "mesh/face_outline.h"
#include "mesh/face_patches.h"
#include "mesh/sharp_edges.h"

namespace rad::mesh {

class PatchMemory {
 public:
  /// All that face_patches() looks at: places of the outline, its edges, lengths, and sharp edges.
  using Key = std::vector<std::int64_t>;
  static Key key_of(const geom::dvec3& normal, const FaceOutline& outline, std::span<const geom::LatticePoint> points,
                    const FaceLengths& lengths, std::span<const SharpEdge> sharp);

  /// Nothing where the face is new. May be called from several threads while nothing is kept.
  [[nodiscard]] const FacePatches* find(const Key& key) const {
    const auto known = patches_.find(key);
    return known == patches_.end() ? nullptr : &known->second;
  }
  void keep(Key key, const FacePatches& patches) { patches_.try_emplace(std::move(key), patches); }

 private:
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t mixed = key.size();
      for (const std::int64_t value : key) {
        mixed = (mixed ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
        mixed ^= mixed >> 29;
      }
      return mixed;
    }
  };
  std::unordered_map<Key, FacePatches, Hash> patches_;
};

inline PatchMemory::Key PatchMemory::key_of(const geom::dvec3& normal, const FaceOutline& outline,
                                            std::span<const geom::LatticePoint> points, const FaceLengths& lengths,
                                            std::span<const SharpEdge> sharp) {
  Key key;
  const auto add = [&](double value) { key.push_back(std::bit_cast<std::int64_t>(value)); };
  for (const double value : {normal.x, normal.y, normal.z, lengths.longest, lengths.spacing}) add(value);
  key.push_back(lengths.tolerance);
  key.push_back(static_cast<std::int64_t>(lengths.method));
  const auto add_point = [&](PointId id) {
    for (const std::int32_t value : {points[id].x, points[id].y, points[id].z}) key.push_back(value);
  };
  for (const PointId id : outline.longest_edge) add_point(id);
  key.push_back(static_cast<std::int64_t>(outline.ids.size()));
  for (const PointId id : outline.ids) add_point(id);
  for (const auto* edges : {&outline.outline, &outline.inner}) {
    key.push_back(static_cast<std::int64_t>(edges->size()));
    for (const geom::PointEdge& edge : *edges) key.push_back(std::int64_t{edge[0]} << 32 | edge[1]);
  }
  key.insert(key.end(), outline.single.begin(), outline.single.end());
  for (const auto& [ends, clearance] : sharp) {
    for (const scene::PointId id : ends) add_point(id);
    add(clearance);
  }
  return key;
}

}  // namespace rad::mesh
