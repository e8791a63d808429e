#include "cli/convert_faces.h"

#include <array>
#include <map>
#include <utility>

#include "scene/lattice_model.h"
#include "validate/context.h"
#include "validate/face_triangles.h"
#include "writers/face_triangles.h"

namespace rad::cli {
namespace {

using scene::Face;
using scene::Scene;

/// Builds a scene face by face from corners of another one.
class CornerCopy {
 public:
  explicit CornerCopy(const Scene& from) : from_(from), to_(from) {
    to_.faces.clear();
    to_.loops.clear();
    to_.corners.clear();
    to_.smoothing_groups.clear();
    to_.attributes.texture_coordinates.row_of_corner.clear();
    to_.attributes.normals.row_of_corner.clear();
  }

  /// A face like `like` with one loop over these corners of the other scene.
  template <typename Corners>
  void add(const Face& like, const Corners& corners) {
    Face face = like;
    face.first_loop = static_cast<std::uint32_t>(to_.loops.size());
    face.loop_count = 1;
    to_.loops.push_back({static_cast<std::uint32_t>(to_.corners.size()), static_cast<std::uint32_t>(corners.size())});
    for (const std::uint32_t corner : corners) {
      to_.corners.push_back(from_.corners[corner]);
      copy_row(from_.attributes.texture_coordinates, to_.attributes.texture_coordinates, corner);
      copy_row(from_.attributes.normals, to_.attributes.normals, corner);
    }
    to_.faces.push_back(face);
    if (!from_.smoothing_groups.empty()) {
      to_.smoothing_groups.push_back(from_.smoothing_groups[static_cast<std::size_t>(&like - from_.faces.data())]);
    }
  }

  Scene take() { return std::move(to_); }

 private:
  template <typename Value>
  static void copy_row(const scene::CornerValues<Value>& from, scene::CornerValues<Value>& to, std::uint32_t corner) {
    if (!from.empty()) to.row_of_corner.push_back(from.row(corner));
  }

  const Scene& from_;
  Scene to_;
};

/// For the points of a face one of its corners each.
std::map<scene::PointId, std::uint32_t> corners_by_point(const Scene& scene, const scene::LatticeModel& model,
                                                         const Face& face) {
  std::map<scene::PointId, std::uint32_t> corners;
  for (const scene::Loop& loop : scene.loops_of(face)) {
    const auto points = model.corners_of(loop);
    for (std::uint32_t i = 0; i < loop.count; ++i) corners.emplace(points[i], loop.first + i);
  }
  return corners;
}

}  // namespace

ConvertedFaces faces_for(const Scene& scene, bool triangles, const std::optional<geom::ToleranceRequest>& tolerance) {
  ConvertedFaces converted;
  if (!triangles) {
    converted.scene = scene;
    return converted;
  }
  const scene::LatticeModel model = scene::build_lattice_model(scene);
  const auto chosen = validate::chosen_tolerance(scene, model, tolerance, converted.problem);
  if (!chosen) return converted;
  const validate::FaceTriangles divided = validate::triangulate_faces(scene, model, *chosen);
  CornerCopy copy(scene);
  auto next = divided.triangles.begin();
  for (scene::FaceId id = 0; id < scene.faces.size(); ++id) {
    const Face& face = scene.faces[id];
    const auto first = next;
    while (next != divided.triangles.end() && next->face == id) ++next;
    if (writers::triangles_of(scene, face)) {
      const scene::Loop& loop = scene.loops[face.first_loop];
      std::vector<std::uint32_t> corners;
      for (std::uint32_t i = 0; i < loop.count; ++i) corners.push_back(loop.first + i);
      copy.add(face, corners);
      continue;
    }
    converted.left_out += first == next ? 1 : 0;
    const auto corner_of = corners_by_point(scene, model, face);
    for (auto triangle = first; triangle != next; ++triangle) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) corners[i] = corner_of.at(triangle->points[i]);
      copy.add(face, corners);
    }
  }
  converted.scene = copy.take();
  return converted;
}

}  // namespace rad::cli
