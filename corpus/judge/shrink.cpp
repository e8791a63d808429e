#include "corpus/judge/shrink.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace rad::corpus {
namespace {

using scene::FaceId;
using scene::Scene;

// The fewest faces, one-minimal: of n parts one is left out; parts are halved where none can be.
std::vector<FaceId> fewest_faces(const Scene& scene, const StillFails& still_fails) {
  std::vector<FaceId> faces(scene.faces.size());
  std::iota(faces.begin(), faces.end(), FaceId{0});
  std::size_t parts = 2;
  while (faces.size() >= 2) {
    parts = std::min(parts, faces.size());
    bool dropped = false;
    for (std::size_t part = 0; part < parts && !dropped; ++part) {
      std::vector<FaceId> rest = faces;
      const auto at = [&](std::size_t i) { return static_cast<std::ptrdiff_t>(i * faces.size() / parts); };
      rest.erase(rest.begin() + at(part), rest.begin() + at(part + 1));
      dropped = still_fails(with_faces(scene, rest));
      if (dropped) faces = std::move(rest);
    }
    if (!dropped && parts == faces.size()) break;
    parts = dropped ? std::max<std::size_t>(parts - 1, 2) : 2 * parts;
  }
  return faces;
}

geom::dvec3 rounded(const geom::dvec3& p, double step) {
  return {std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
}

// Equal places stay equal, so that what was one corner does not come apart.
Scene with_rounded(const Scene& scene, const geom::dvec3& place, double step) {
  Scene result = scene;
  for (geom::dvec3& p : result.vertices) {
    if (p == place) p = rounded(p, step);
  }
  return result;
}

// Rounder places make another scene, which may fail for another reason.
constexpr int kFewestDecimals = 2, kMostDecimals = 7;

Scene with_round_coordinates(Scene scene, const StillFails& still_fails) {
  for (int decimals = kFewestDecimals; decimals <= kMostDecimals; ++decimals) {
    Scene all = scene;
    for (geom::dvec3& p : all.vertices) p = rounded(p, std::pow(10, -decimals));
    if (!still_fails(all)) continue;
    scene = std::move(all);
    break;
  }
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    for (int decimals = kFewestDecimals; decimals <= kMostDecimals; ++decimals) {
      Scene one = with_rounded(scene, scene.vertices[i], std::pow(10, -decimals));
      if (one.vertices[i] == scene.vertices[i]) break;
      if (!still_fails(one)) continue;
      scene = std::move(one);
      break;
    }
  }
  return scene;
}

}  // namespace

Scene with_faces(const Scene& scene, std::span<const FaceId> kept) {
  Scene result = scene;
  result.faces.clear();
  result.loops.clear();
  result.corners.clear();
  result.vertices.clear();
  result.vertex_records.clear();
  std::vector<scene::VertexId> new_id(scene.vertices.size(), 0xffffffffu);
  for (const FaceId id : kept) {
    scene::Face face = scene.faces[id];
    face.first_loop = static_cast<std::uint32_t>(result.loops.size());
    for (const scene::Loop& loop : scene.loops_of(scene.faces[id])) {
      result.loops.push_back({static_cast<std::uint32_t>(result.corners.size()), loop.count});
      for (const scene::VertexId vertex : scene.corners_of(loop)) {
        if (new_id[vertex] == 0xffffffffu) {
          new_id[vertex] = static_cast<scene::VertexId>(result.vertices.size());
          result.vertices.push_back(scene.vertices[vertex]);
        }
        result.corners.push_back(new_id[vertex]);
      }
    }
    result.faces.push_back(face);
  }
  return result;
}

Scene shrunken(const Scene& scene, const StillFails& still_fails) {
  return with_round_coordinates(with_faces(scene, fewest_faces(scene, still_fails)), still_fails);
}

}  // namespace rad::corpus
