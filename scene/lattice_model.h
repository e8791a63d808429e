// The lattice model: the raw scene on integer coordinates, with equal positions made one vertex, and maps back.
#pragma once

#include <span>
#include <vector>

#include "geom/lattice.h"
#include "geom/tolerance.h"
#include "scene/scene.h"

namespace rad::scene {

using geom::LatticePoint;

/// Id of a lattice vertex; ids follow the lexicographic order of positions, whatever the order in the file.
using PointId = std::uint32_t;
inline constexpr PointId kNoPoint = 0xffffffffu;

/// Faces keep their ids; a face with a corner that is not finite has no loops here (`is_left_out`).
struct LatticeModel {
  geom::Lattice lattice;
  geom::Box box;  ///< file units, of the finite vertices that faces use

  std::vector<LatticePoint> points;      ///< strictly ascending
  std::vector<PointId> point_of_vertex;  ///< per raw vertex; kNoPoint where not finite or unused
  std::vector<PointId> corners;          ///< per raw corner, same indexing as Scene::corners; kNoPoint likewise
  std::vector<bool> left_out;            ///< per face

  [[nodiscard]] std::span<const PointId> corners_of(const Loop& loop) const {
    return std::span(corners).subspan(loop.first, loop.count);
  }
  [[nodiscard]] dvec3 position(PointId id) const { return lattice.position(points[id]); }
};

/// Derives the lattice model, on the lattice that the scene records where it fits and its T is of use, else on
/// lattice_for(box). Without a finite vertex the model is empty and every face left out.
LatticeModel build_lattice_model(const Scene& scene);

/// What the tolerance of this scene is derived from. The median object diagonal is over connected components of
/// faces that share a lattice vertex.
geom::ToleranceBasis tolerance_basis(const Scene& scene, const LatticeModel& model);

}  // namespace rad::scene
