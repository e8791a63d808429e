#include "scene/scene_builder.h"

#include <algorithm>
#include <cmath>
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

bool is_finite(const dvec2& value) { return std::isfinite(value.x) && std::isfinite(value.y); }
bool is_finite(const dvec3& value) {
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
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

EntityId SceneBuilder::add_entity(std::string name) {
  if (name.empty()) return 0;
  scene_.entities.push_back(std::move(name));
  return static_cast<EntityId>(scene_.entities.size() - 1);
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
  face.entity = entity_;
  face.source = {section_, record};
  append_loop(outer);
  scene_.faces.push_back(face);
  if (smoothing_group_ != 0) {
    scene_.smoothing_groups.resize(scene_.faces.size() - 1, 0);
    scene_.smoothing_groups.push_back(smoothing_group_);
  }
  return static_cast<FaceId>(scene_.faces.size() - 1);
}

RowId SceneBuilder::add_texture_coordinates(const dvec2& value) {
  scene_.attributes.texture_coordinates.table.push_back(value);
  return static_cast<RowId>(scene_.attributes.texture_coordinates.table.size() - 1);
}

RowId SceneBuilder::add_normal(const dvec3& value) {
  scene_.attributes.normals.table.push_back(value);
  return static_cast<RowId>(scene_.attributes.normals.table.size() - 1);
}

template <typename Value>
void SceneBuilder::set_rows(CornerValues<Value>& values, std::span<const RowId> rows) {
  values.row_of_corner.resize(scene_.loops.back().first, kNoRow);
  values.row_of_corner.insert(values.row_of_corner.end(), rows.begin(), rows.end());
}

template void SceneBuilder::set_rows(CornerValues<dvec2>&, std::span<const RowId>);
template void SceneBuilder::set_rows(CornerValues<dvec3>&, std::span<const RowId>);

// Leaves every face with sound values at all of its corners or at none, and nothing at all where no face has any.
template <typename Value>
void SceneBuilder::settle(CornerValues<Value>& values) {
  if (values.row_of_corner.empty() || values.table.empty()) {
    values = {};
    return;
  }
  values.row_of_corner.resize(scene_.corners.size(), kNoRow);
  const auto is_sound = [&](RowId row) { return row < values.table.size() && is_finite(values.table[row]); };
  bool any = false;
  for (const Face& face : scene_.faces) {
    bool all = true, named = false;
    for (const Loop& loop : scene_.loops_of(face)) {
      const std::span rows(values.row_of_corner.data() + loop.first, loop.count);
      all = all && std::ranges::all_of(rows, is_sound);
      named = named || std::ranges::any_of(rows, [](RowId row) { return row != kNoRow; });
    }
    any = any || (all && named);
    if (all || !named) continue;
    ++faces_without_rows_;
    for (const Loop& loop : scene_.loops_of(face)) {
      std::fill_n(values.row_of_corner.begin() + loop.first, loop.count, kNoRow);
    }
  }
  if (!any) {
    values = {};
    return;
  }
  for (Value& value : values.table) {
    if (!is_finite(value)) value = Value(0.0);
  }
}

Scene SceneBuilder::take() {
  settle(scene_.attributes.texture_coordinates);
  settle(scene_.attributes.normals);
  if (!scene_.smoothing_groups.empty()) scene_.smoothing_groups.resize(scene_.faces.size(), 0);
  return std::move(scene_);
}

void SceneBuilder::add_hole(std::span<const VertexId> loop) {
  append_loop(loop);
  ++scene_.faces.back().loop_count;
}

}  // namespace rad::scene
