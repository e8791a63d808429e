// Where the nodes of a mesh receive.
#pragma once

#include <vector>

#include "mesh/radiosity_mesh.h"
#include "solve/strata.h"

namespace rad::solve {

/// The corners of an element or a patch in space.
Stratum stratum_of(const mesh::Corners& corners, const mesh::RadiosityMesh& mesh);

/// Distance by which rays start above the surface of their receiver and end above that of their radiator, file units:
/// two pitches, and never below 2^-20 of the model's diagonal. Rays are traced in single precision (2^-24 relative) by
/// a test that loses about two bits more. At the smallest tolerance of 8 pitches it stays below T.
double lift_of(const mesh::RadiosityMesh& mesh);

/// Receivers of a mesh: its nodes, then the centres of its elements, then those of the patches that have more than one
/// element.
using ReceiverId = std::uint32_t;

/// The receiver at the centre of an element.
inline ReceiverId centre_of(const mesh::RadiosityMesh& mesh, std::size_t element) {
  return static_cast<ReceiverId>(mesh.nodes.size() + element);
}

/// At a node it is the node moved inward into its sector by max(4 T, 1e-3 element size), at most a quarter of the
/// element size, and off its surface by the lift. So a node in the plane of an emitter that it shares an edge with gets
/// the one-sided limit, and a node at the foot of a wall is not half inside it.
Receiver receiver_at(const mesh::Node& node, double tolerance, double lift);

/// One receiver for each node, each element, each divided patch. The values at the centres serve the means of radiators
/// and tell where elements are too coarse: with the nodes alone, the error of a mean falls with the square of the
/// element size and has one sign along an edge between two walls.
std::vector<Receiver> receivers_of(const mesh::RadiosityMesh& mesh);

}  // namespace rad::solve
