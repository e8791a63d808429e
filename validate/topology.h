// Who shares an edge with whom, at the tolerance: vertices within T count as one, and an edge with T-vertices counts as
// the chain through them. This is the connectivity that the Grouper will make explicit.
#pragma once

#include <span>
#include <vector>

#include "validate/contacts.h"

namespace rad::validate {

/// One use of a subedge by a face; `forward` where the face runs from a to b.
struct Coedge {
  FaceId face = 0;
  bool forward = true;
};

/// A stretch between neighbouring vertices, a < b, with all faces that use it. A bridge that a face runs along in both
/// directions does not count.
struct Subedge {
  PointId a = 0;
  PointId b = 0;
  std::uint32_t first = 0;  ///< in Topology::coedges
  std::uint32_t count = 0;
};

/// A set of faces connected over subedges: over all that two faces share, and over those that more share where the
/// faces are of one named object.
struct Component {
  std::uint32_t faces = 0;
  PointId smallest_point = 0;
  std::uint32_t subedges = 0;        ///< 0 where all collapse at the tolerance: a lone face about as thin as T
  std::uint32_t open_subedges = 0;   ///< used by one face of the component
  double open_length = 0;            ///< pitches
  bool balanced = true;              ///< every subedge is used as often forward as backward
  geom::Int128 volume6 = 0;          ///< six times the signed volume in pitches³, exact
  double area = 0;                   ///< pitches²
  geom::LatticePoint low{}, high{};  ///< box

  [[nodiscard]] bool closed() const { return subedges > 0 && open_subedges == 0 && balanced; }
};

inline constexpr std::uint32_t kNoComponent = 0xffffffffu;

struct Topology {
  std::vector<Subedge> subedges;  ///< by (a, b)
  std::vector<Coedge> coedges;
  std::vector<PointId> representative;           ///< per point: the vertex it counts as
  std::vector<std::uint32_t> component_of_face;  ///< kNoComponent for faces that have no area
  std::vector<Component> components;             ///< by their smallest point, so not by the order of faces
  std::vector<std::uint32_t> surface_of_face;    ///< representative face of the paper's surface

  [[nodiscard]] std::span<const Coedge> coedges_of(const Subedge& subedge) const {
    return std::span(coedges).subspan(subedge.first, subedge.count);
  }
};

/// Largest angle between faces of one surface, degrees (paper 2.1: continuous normals).
inline constexpr double kSmoothAngleDegrees = 30;

Topology build_topology(const scene::Scene& scene, const scene::LatticeModel& model, const FaceTriangles& triangles,
                        const Contacts& contacts);

}  // namespace rad::validate
