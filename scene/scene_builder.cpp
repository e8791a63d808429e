#include "scene/scene_builder.h"

#include <utility>

namespace rad::scene {
namespace {

// Id of a name in a table whose entry 0 is the unnamed one; `make` appends a new entry.
template <typename Ids, typename Make>
std::uint32_t id_of(std::string_view name, Ids& ids, std::size_t count, Make make) {
  if (name.empty()) return 0;
  const auto [entry, fresh] = ids.try_emplace(std::string(name), static_cast<std::uint32_t>(count));
  if (fresh) make(entry->first);
  return entry->second;
}

}  // namespace

std::uint32_t SceneBuilder::add_section(SourceSection section) {
  scene_.sections.push_back(std::move(section));
  section_ = static_cast<std::uint32_t>(scene_.sections.size() - 1);
  return section_;
}

VertexId SceneBuilder::add_vertex(const dvec3& position) {
  scene_.vertices.push_back(position);
  return static_cast<VertexId>(scene_.vertices.size() - 1);
}

VertexId SceneBuilder::add_vertex(const dvec3& position, std::uint64_t record) {
  scene_.vertex_records.push_back(record);
  return add_vertex(position);
}

ObjectId SceneBuilder::object(std::string_view name) {
  return id_of(name, object_ids_, scene_.objects.size(), [&](const std::string& n) { scene_.objects.push_back(n); });
}

GroupId SceneBuilder::group(std::string_view name) {
  return id_of(name, group_ids_, scene_.groups.size(), [&](const std::string& n) { scene_.groups.push_back(n); });
}

MaterialId SceneBuilder::material(std::string_view name) {
  return id_of(name, material_ids_, scene_.materials.size(), [&](const std::string& n) {
    Material material;
    material.name = n;
    scene_.materials.push_back(std::move(material));
  });
}

void SceneBuilder::append_loop(std::span<const VertexId> loop) {
  scene_.loops.push_back({static_cast<std::uint32_t>(scene_.corners.size()), static_cast<std::uint32_t>(loop.size())});
  scene_.corners.insert(scene_.corners.end(), loop.begin(), loop.end());
}

FaceId SceneBuilder::add_face(std::span<const VertexId> outer, std::uint64_t record) {
  Face face;
  face.first_loop = static_cast<std::uint32_t>(scene_.loops.size());
  face.material = material_;
  face.object = object_;
  face.group = group_;
  face.source = {section_, record};
  append_loop(outer);
  scene_.faces.push_back(face);
  return static_cast<FaceId>(scene_.faces.size() - 1);
}

void SceneBuilder::add_hole(std::span<const VertexId> loop) {
  append_loop(loop);
  ++scene_.faces.back().loop_count;
}

}  // namespace rad::scene
