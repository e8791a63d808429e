// The patch mesh: radiators with their connectivity. Vertices are nodes, so that it is a manifold by construction.
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <vector>

#include "geom/lattice.h"
#include "geom/tolerance.h"
#include "scene/scene.h"

namespace rad::mesh {

/// Positions are lattice coordinates: exact in double.
struct PatchTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::None);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
  VertexTraits {
    std::uint32_t lattice_point = 0;  ///< index into PatchMesh::points
  };
  FaceTraits {
    std::uint32_t face = 0;  ///< index into PatchMesh::faces
  };
};

/// Faces are patches. A vertex is one sector of a surface at a lattice point: patches share it where they are connected
/// across smooth edges around the point (two patches, opposite directions, one material and object, normals within
/// 30°, no third face at the edge). At all other edges every side has vertices of its own.
using PatchConnectivity = OpenMesh::PolyMesh_ArrayKernelT<PatchTraits>;

/// A face of the conforming model, or a triangle of one, that patches were made of.
struct PatchedFace {
  geom::dvec3 normal{0, 0, 0};  ///< unit length, to the front
  double area = 0;              ///< file units²
  scene::MaterialId material = 0;
  scene::ObjectId object = 0;
  scene::GroupId group = 0;
  std::uint32_t origin = 0;       ///< the face of the model that it is, or is a triangle of
  bool whole = false;             ///< its patches are not to be divided
  double least_corner_deg = 180;  ///< the smallest angle of its outline
};

struct PatchMesh {
  geom::Lattice lattice;
  geom::Tolerance tolerance;
  std::vector<geom::LatticePoint> points;  ///< the model's, then those of the division of edges and of faces
  std::vector<PatchedFace> faces;
  PatchConnectivity patches;  ///< ascending by face; triangles and strictly convex quadrilaterals
};

}  // namespace rad::mesh
