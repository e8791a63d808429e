// Whether the triangles of a mesh are the surface of a solid.
#pragma once

#include <cstdint>
#include <span>

namespace rad::writers::gltf {

/// Name of the extension that says so of a mesh.
inline constexpr const char* kManifold = "EXT_mesh_manifold";

/// Whether every edge of the triangles, three corners each, has exactly one triangle on each side, which pass it in
/// opposite directions. Vertices are told apart by their numbers: one that is repeated for a seam opens the surface.
bool is_closed_manifold(std::span<const std::uint32_t> corners);

}  // namespace rad::writers::gltf
