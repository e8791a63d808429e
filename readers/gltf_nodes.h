// The scene graph of a glTF document, flattened into the meshes it places.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "readers/gltf_accessors.h"

namespace rad::readers::gltf {

struct MeshInstance {
  std::uint64_t mesh = 0;
  std::optional<std::uint64_t> node;  ///< none in a file without nodes
  std::optional<std::uint64_t> copy;  ///< which of EXT_mesh_gpu_instancing, none where the node has no such copies
  glm::dmat4 world{1.0};
};

/// Every mesh of the default scene, or of all root nodes where the file names none, or every mesh once where it has
/// no nodes; in depth-first order. A node below several parents is an instance for each. Cycles, depths beyond
/// Limits::node_depth and instances beyond Limits::instances are ParseErrors and left out.
std::vector<MeshInstance> mesh_instances(const Document& document, const Accessors& accessors);

}  // namespace rad::readers::gltf
