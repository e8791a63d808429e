// Adaptive refinement of a solution (paper 3.4.3): elements are divided where the radiosity bends or steps.
#pragma once

#include <vector>

#include "mesh/element_mesh.h"
#include "solve/replay.h"
#include "solve/solution.h"

namespace rad::solve {

/// All that it refers to outlives it. `solution` is one of the leaves of `elements` as they are.
class Refinement {
 public:
  /// `whole` are patches that are not divided.
  Refinement(Solution& solution, mesh::ElementMesh& elements, const RefineOptions& options,
             const std::vector<bool>& whole);

  /// Divides, level by level, and appends the radiosity of each new node to that of the nodes there are.
  void run(std::vector<dvec3>& radiosity, Progress& progress);

 private:
  /// An element that is to be divided, and how much there is to gain.
  struct Rough {
    mesh::ElementId element = 0;
    double gain = 0;
  };

  /// A point that a replay is asked for: a node, or the centre of a leaf.
  struct Wanted {
    std::uint32_t element = 0;  ///< of the mesh that was solved, that it lies in
    mesh::NodeId node = 0;
    mesh::ElementId leaf = mesh::kNoElement;  ///< for a centre
  };

  [[nodiscard]] double edge_of(mesh::ElementId element, const mesh::RadiosityMesh& mesh) const;
  [[nodiscard]] double roughness(const mesh::Corners& corners, const std::vector<dvec3>& radiosity,
                                 const dvec3& centre) const;
  void look_at(mesh::ElementId leaf, double roughness, const mesh::RadiosityMesh& mesh);
  void look_at_first_leaves(const std::vector<dvec3>& radiosity);
  [[nodiscard]] std::vector<Wanted> wanted(std::size_t first, std::size_t known, const mesh::RadiosityMesh& mesh) const;
  [[nodiscard]] Receiver receiver_of(const Wanted& wanted, const mesh::RadiosityMesh& mesh) const;
  void find_elements();
  [[nodiscard]] std::uint32_t element_at(mesh::ElementId leaf, const dvec3& point) const;
  /// Elements from `first` on and nodes that have no radiosity yet are new.
  void look_at_new_leaves(std::size_t first, const mesh::RadiosityMesh& mesh, std::vector<dvec3>& radiosity);
  [[nodiscard]] std::vector<mesh::ElementId> chosen();
  [[nodiscard]] dvec3 radiosity_of(mesh::PatchId patch, const dvec3& irradiance) const;
  [[nodiscard]] mesh::PatchId patch_of(const Wanted& wanted) const {
    return solution_.source().mesh.elements[wanted.element].patch;
  }

  Solution& solution_;
  mesh::ElementMesh& elements_;
  const RefineOptions& options_;
  const std::vector<bool>& whole_;
  std::vector<Shot> shot_by_;
  dvec3 usual_{0, 0, 0};  ///< mean of what surfaces reflect, W/m²
  std::vector<mesh::ElementId>
      first_leaf_;  ///< for every element of the mesh that was solved: the leaf it is a piece of
  std::vector<std::uint32_t>
      first_element_;  ///< for every element there is: the first piece of the leaf that it came from
  std::vector<Rough> rough_;
};

}  // namespace rad::solve
