// Where the faces of DXF entities go, and what every entity has in common: layer, colour, handle, placement.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "readers/dxf_groups.h"
#include "readers/dxf_tables.h"
#include "readers/reader.h"
#include "scene/scene_builder.h"

namespace rad::readers::dxf {

/// Where the entities of a block or of the drawing lie, and what they take over from the INSERT.
struct Placement {
  glm::dmat4 world{1.0};
  std::string_view layer;  ///< of entities on layer 0; empty in the drawing itself
  int colour = 7;          ///< of entities that are coloured by block
  std::optional<std::uint32_t> true_colour;
  std::string block;        ///< empty in the drawing itself
  std::string insert;       ///< handle of the INSERT
  std::uint64_t depth = 0;  ///< of nested INSERTs
};

/// The colour of an entity: an index, or a true colour, which comes first.
struct Colour {
  int index = 7;
  std::optional<std::uint32_t> true_colour;
  bool by_layer = true;
};

/// The frame in which planar entities are drawn, from their extrusion direction (arbitrary axis algorithm of the DXF
/// reference). The identity for +Z.
glm::dmat4 object_frame(const dvec3& extrusion);

class Surfaces {
 public:
  Surfaces(const Input& input, Layers& layers, scene::SceneBuilder& builder, scene::ReadIssues& issues)
      : input_(input), layers_(layers), builder_(builder), issues_(issues) {}

  /// Begins an entity. False where it is not to be seen: its layer is off or frozen, it is hidden or in paper space.
  bool begin(const Entity& entity, const Placement& placement);
  /// Layer and colour that an entity in this placement has.
  [[nodiscard]] const Layer& layer_of(const Entity& entity, const Placement& placement) const;
  [[nodiscard]] Colour colour_of(const Entity& entity, const Placement& placement) const;

  /// Points from here on are in this frame within the placement; begin() resets it.
  void use_frame(const glm::dmat4& frame);

  scene::VertexId add_vertex(const dvec3& point, std::uint64_t line);
  /// A face; under a mirroring placement turned over, so that its front stays its front.
  void add_face(std::span<const scene::VertexId> corners, std::uint64_t line);
  void add_face(std::initializer_list<scene::VertexId> corners, std::uint64_t line) {
    add_face(std::span(corners.begin(), corners.size()), line);
  }

  /// Room for no more vertices or faces; an issue says so.
  [[nodiscard]] bool full() const { return full_; }
  void count_unsupported(std::string what, std::uint64_t line);
  void refuse(scene::ReadIssueKind kind, std::string what, std::uint64_t line);

 private:
  scene::MaterialId material_of(const Layer& layer, const Colour& colour);
  bool stop(std::string why, std::uint64_t line);

  const Input& input_;
  Layers& layers_;
  scene::SceneBuilder& builder_;
  scene::ReadIssues& issues_;
  glm::dmat4 placed_{1.0};
  glm::dmat4 world_{1.0};
  bool mirrored_ = false;
  bool full_ = false;
  std::vector<scene::VertexId> turned_;
};

/// 3DFACE, SOLID, TRACE, LINE, CIRCLE, ARC and LWPOLYLINE. False for entities of other types.
bool add_simple_entity(const Entity& entity, Surfaces& surfaces);

}  // namespace rad::readers::dxf
