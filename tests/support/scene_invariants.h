// What holds of every Scene, however bad the model in it is.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace rad::tests {

/// The first invariant of the raw model that this scene breaks, in words; empty for a sound one.
inline std::string broken_invariant(const scene::Scene& scene) {
  if (scene.materials.empty() || scene.objects.empty() || scene.groups.empty()) return "no unnamed entry";
  for (const scene::VertexId corner : scene.corners) {
    if (corner >= scene.vertices.size()) return "a corner names no vertex";
  }
  for (const scene::Loop& loop : scene.loops) {
    if (std::uint64_t{loop.first} + loop.count > scene.corners.size()) return "a loop reaches beyond the corners";
  }
  for (const scene::Face& face : scene.faces) {
    if (face.loop_count == 0) return "a face has no outer loop";
    if (std::uint64_t{face.first_loop} + face.loop_count > scene.loops.size()) return "a face names no loop";
    if (face.material >= scene.materials.size()) return "a face names no material";
    if (face.object >= scene.objects.size()) return "a face names no object";
    if (face.group >= scene.groups.size()) return "a face names no group";
    if (face.source.section >= scene.sections.size()) return "a face names no section of the source";
  }
  const bool records_fit = scene.vertex_records.empty() || scene.vertex_records.size() == scene.vertices.size();
  return records_fit ? "" : "vertex records and vertices differ in number";
}

}  // namespace rad::tests
