#include "corpus/mutate/draft.h"

#include <algorithm>
#include <array>

namespace rad::corpus {

Draft::Draft(const scene::Scene& scene) : scene_(scene) {
  for (const scene::Face& face : scene.faces) {
    DraftFace& draft = faces.emplace_back();
    draft.record = face;
    for (const scene::Loop& loop : scene.loops_of(face)) {
      const auto corners = scene.corners_of(loop);
      draft.loops.emplace_back(corners.begin(), corners.end());
    }
  }
  scene_.corners.clear();
  scene_.loops.clear();
  scene_.faces.clear();
}

VertexId Draft::add_vertex(const dvec3& position) {
  scene_.vertices.push_back(position);
  if (!scene_.vertex_records.empty()) scene_.vertex_records.push_back(0);
  return static_cast<VertexId>(scene_.vertices.size() - 1);
}

scene::ObjectId Draft::add_object(std::string_view name) {
  scene_.objects.emplace_back(name);
  return static_cast<scene::ObjectId>(scene_.objects.size() - 1);
}

scene::MaterialId Draft::add_material(std::string_view name) {
  scene_.materials.push_back({.name = std::string(name), .reflectance_stated = true});
  return static_cast<scene::MaterialId>(scene_.materials.size() - 1);
}

FaceId Draft::add_face(const std::vector<dvec3>& ring, scene::MaterialId material, scene::ObjectId object) {
  std::vector<VertexId> ids;
  for (const dvec3& position : ring) ids.push_back(add_vertex(position));
  return add_face_of(std::move(ids), material, object);
}

FaceId Draft::add_face_of(std::vector<VertexId> ring, scene::MaterialId material, scene::ObjectId object) {
  DraftFace& face = faces.emplace_back();
  face.loops.push_back(std::move(ring));
  face.record.material = material;
  face.record.object = object;
  return static_cast<FaceId>(faces.size() - 1);
}

FaceId Draft::add_box(const dvec3& centre, const dvec3& u, const dvec3& v, const dvec3& n, scene::MaterialId material,
                      scene::ObjectId object) {
  std::array<VertexId, 8> at{};
  for (std::size_t i = 0; i < 8; ++i) {
    at[i] = add_vertex(centre + (i & 1 ? u : -u) + (i & 2 ? v : -v) + (i & 4 ? n : -n));
  }
  const FaceId base = add_face_of({at[0], at[2], at[3], at[1]}, material, object);
  add_face_of({at[4], at[5], at[7], at[6]}, material, object);
  add_face_of({at[0], at[1], at[5], at[4]}, material, object);
  add_face_of({at[1], at[3], at[7], at[5]}, material, object);
  add_face_of({at[3], at[2], at[6], at[7]}, material, object);
  add_face_of({at[2], at[0], at[4], at[6]}, material, object);
  return base;
}

scene::Scene Draft::scene() const {
  scene::Scene result = scene_;
  for (const DraftFace& draft : faces) {
    scene::Face face = draft.record;
    face.first_loop = static_cast<std::uint32_t>(result.loops.size());
    face.loop_count = static_cast<std::uint32_t>(draft.loops.size());
    for (const auto& loop : draft.loops) {
      result.loops.push_back(
          {static_cast<std::uint32_t>(result.corners.size()), static_cast<std::uint32_t>(loop.size())});
      result.corners.insert(result.corners.end(), loop.begin(), loop.end());
    }
    result.faces.push_back(face);
  }
  return result;
}

void reverse(DraftFace& face) {
  for (auto& loop : face.loops) std::reverse(loop.begin(), loop.end());
}

}  // namespace rad::corpus
