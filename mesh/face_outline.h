// A face as its patches see it: the divided loops and inner edges, and points that other faces need.
#pragma once

#include <array>
#include <vector>

#include "geom/constrained_triangulation.h"
#include "mesh/edge_division.h"
#include "scene/conforming_model.h"

namespace rad::mesh {

using geom::PointEdge;

/// Edges hold indices into `ids`.
struct FaceOutline {
  std::vector<PointId> ids;  ///< points of EdgeDivision; loops first, then inner edges, then single points
  std::vector<PointEdge> outline;
  std::vector<PointEdge> inner;
  std::vector<std::uint32_t> single;  ///< where other faces touch this one in a point
  EdgeKey longest_edge{};             ///< of the undivided loops, along the loop
  std::uint32_t longest_edge_parts = 1;
};

FaceOutline face_outline(const scene::ConformingModel& model, const scene::ConformingFace& face,
                         const EdgeDivision& division);

}  // namespace rad::mesh
