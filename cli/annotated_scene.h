// A model as it is coloured to show something: every sort of face a node and a material of its own, with a legend.
#pragma once

#include <span>
#include <string>

#include "scene/scene.h"

namespace rad::cli {

/// A sort of face.
struct FaceSort {
  std::string name;             ///< of its node and material
  std::string meaning;          ///< for the legend
  geom::dvec3 colour{0, 0, 0};  ///< linear
};

/// Puts every face of `scene` into the object and material of its sort: `sort_of_face` has a number for each. Sorts
/// that no face has are left out by the writer.
void put_into_sorts(scene::Scene& scene, std::span<const FaceSort> sorts, std::span<const std::size_t> sort_of_face);

/// Writes a GLB or glTF file of a scene in sorts, with the legend in its extras. Returns what went wrong, empty for
/// nothing.
std::string write_annotated(const std::string& path, const scene::Scene& scene, std::span<const FaceSort> sorts,
                            const std::optional<scene::RecordedLattice>& lattice);

/// Why no annotated model can be written to `path`; empty where one can.
std::string annotation_problem(const std::string& path);

}  // namespace rad::cli
