// The one way in which readers and generators make a Scene: keeps its invariants while faces arrive one by one.
#pragma once

#include <string_view>
#include <unordered_map>

#include "scene/scene.h"

namespace rad::scene {

class SceneBuilder {
 public:
  SceneBuilder(std::string path, std::string format) : scene_(empty_scene(std::move(path), std::move(format))) {}

  /// Adds a stretch of the source and makes it the one that faces refer to from now on.
  std::uint32_t add_section(SourceSection section);
  /// Makes a stretch added before the one that faces refer to.
  void use_section(std::uint32_t section) { section_ = section; }

  VertexId add_vertex(const dvec3& position);
  VertexId add_vertex(const dvec3& position, std::uint64_t record);

  /// Ids of names, made on first use. An empty name is id 0.
  ObjectId object(std::string_view name);
  GroupId group(std::string_view name);
  MaterialId material(std::string_view name);
  Material& material_at(MaterialId id) { return scene_.materials[id]; }

  /// A name that records have in the file and no object, group or material has: a handle, a GUID, an identifier.
  EntityId add_entity(std::string name);

  /// What the following faces belong to.
  void use_object(ObjectId id) { object_ = id; }
  void use_group(GroupId id) { group_ = id; }
  void use_material(MaterialId id) { material_ = id; }
  void use_entity(EntityId id) { entity_ = id; }
  void use_smoothing_group(std::uint32_t group) { smoothing_group_ = group; }

  /// Adds a row to the table of texture coordinates or normals.
  RowId add_texture_coordinates(const dvec2& value);
  RowId add_normal(const dvec3& value);

  /// Gives the corners of the loop added last their rows, one for each corner. Rows may be added later; a face that has
  /// rows at some of its corners only, rows that do not exist or values that are not finite is left without any.
  void set_texture_coordinates(std::span<const RowId> rows) { set_rows(scene_.attributes.texture_coordinates, rows); }
  void set_normals(std::span<const RowId> rows) { set_rows(scene_.attributes.normals, rows); }

  /// Adds a face with one outer loop; `hole` adds a further loop to the face added last. Every id must be below
  /// vertex_count(). Loops of fewer than three corners are kept: rules judge them.
  FaceId add_face(std::span<const VertexId> outer, std::uint64_t record);
  void add_hole(std::span<const VertexId> loop);

  [[nodiscard]] std::size_t vertex_count() const { return scene_.vertices.size(); }
  [[nodiscard]] Scene& scene() { return scene_; }

  /// The finished scene. Nothing may be added after it.
  [[nodiscard]] Scene take();

  /// Faces that were left without the texture coordinates or normals that they name, in scenes that have any at all;
  /// known after take().
  [[nodiscard]] std::size_t faces_without_rows() const { return faces_without_rows_; }

 private:
  void append_loop(std::span<const VertexId> loop);
  template <typename Value>
  void set_rows(CornerValues<Value>& values, std::span<const RowId> rows);
  template <typename Value>
  void settle(CornerValues<Value>& values);

  Scene scene_;
  std::unordered_map<std::string, ObjectId> object_ids_;
  std::unordered_map<std::string, GroupId> group_ids_;
  std::unordered_map<std::string, MaterialId> material_ids_;
  ObjectId object_ = 0;
  GroupId group_ = 0;
  MaterialId material_ = 0;
  EntityId entity_ = 0;
  std::uint32_t section_ = 0;
  std::uint32_t smoothing_group_ = 0;
  std::size_t faces_without_rows_ = 0;
};

}  // namespace rad::scene
