#include "cli/mesh_stage.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/statistics.h"

namespace rad::cli {
namespace {

using geom::dvec3;

// Receivers are to be denser than radiators (paper 3.4): by default four times along an edge, and twice that where a
// shadow ends.
constexpr double kElementShare = 0.25;
constexpr double kShadowShare = 0.5;

// Edges that refinement leaves: of the diagonal of the model, and of the tolerance.
constexpr double kShortestShare = 1.0 / 2000;
constexpr double kShortestTolerances = 10;
// Elements that refinement adds: half of those there are, but always as many as cost no more than a few seconds.
constexpr std::size_t kGrowth = 2;
constexpr std::size_t kSmallMeshElements = 20'000;

bool fits(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

}  // namespace

mesh::PatchOptions patch_options(const FixCommand& command, const scene::ConformingModel& model,
                                 const scene::Scene& origin, std::string& problem) {
  mesh::PatchOptions options;
  options.longest_edge = command.patch_size.value_or(mesh::default_patch_length(model));
  options.materials = origin.materials;
  options.method = command.patch_method;
  if (!command.patch_sizes.empty()) options.longest_of_face.assign(model.faces.size(), 0);
  for (const PatchSizeOf& own : command.patch_sizes) {
    bool used = false;
    for (std::size_t f = 0; f < model.faces.size(); ++f) {
      const scene::ConformingFace& face = model.faces[f];
      const bool meant =
          (face.object < origin.objects.size() && fits(own.pattern, origin.objects[face.object])) ||
          (face.material < origin.materials.size() && fits(own.pattern, origin.materials[face.material].name));
      if (meant) options.longest_of_face[f] = own.length;
      used = used || meant;
    }
    if (!used) problem = fmt::format("--patch-size-of: no object and no material is called '{}'", own.pattern);
  }
  return options;
}

mesh::EmeshOptions emesh_options(const FixCommand& command, double patch_size, const scene::Scene& origin) {
  mesh::EmeshOptions options;
  options.longest_edge = command.element_size.value_or(kElementShare * patch_size);
  options.shadow_edge = command.shadow_size.value_or(kShadowShare * options.longest_edge);
  options.search = command.shadow_search;
  options.materials = origin.materials;
  options.dump_hemicube = command.dump_hemicube;
  return options;
}

solve::RefineOptions refine_options(const FixCommand& command, const mesh::ElementMesh& elements, double finest) {
  solve::RefineOptions options;
  options.levels = command.refine_levels;
  const std::size_t leaves = elements.leaves().size();
  options.most_elements = command.most_elements.value_or(leaves + std::max(leaves / kGrowth, kSmallMeshElements));
  dvec3 low(std::numeric_limits<double>::max());
  dvec3 high(-low);
  for (const geom::LatticePoint& point : elements.points()) {
    low = glm::min(low, elements.lattice().position(point));
    high = glm::max(high, elements.lattice().position(point));
  }
  options.shortest_edge =
      std::max(glm::length(high - low) * kShortestShare, kShortestTolerances * elements.tolerance().length);
  if (command.maps_light()) options.shortest_edge = std::max(options.shortest_edge, finest);
  return options;
}

report::MeshFigures mesh_figures(const mesh::PatchMesh& patches, const mesh::ElementMesh& elements,
                                 const mesh::PatchOptions& patch_options, const mesh::EmeshOptions& emesh_options) {
  const mesh::PatchStatistics patch = mesh::patch_statistics(patches);
  const mesh::ElementStatistics element = mesh::element_statistics(elements);
  report::MeshFigures figures;
  figures.patches = patch.triangles + patch.quads;
  figures.elements = element.leaves;
  figures.nodes = element.nodes;
  figures.patch_size = patch_options.longest_edge;
  figures.element_size = emesh_options.longest_edge;
  figures.shape_median = patch.shape.median;
  figures.shape_first_percentile = patch.shape.first;
  figures.quads = patch.quads;
  figures.blunt = {patch.blunt_patches, patch.blunt_shape.median, patch.blunt_shape.first};
  figures.shape_histogram = patch.histogram;
  figures.patches_per_area = patch.area > 0 ? static_cast<double>(figures.patches) / patch.area : 0;
  figures.elements_per_area = patch.area > 0 ? static_cast<double>(element.leaves) / patch.area : 0;
  figures.deepest_level = element.deepest_level;
  figures.bytes_per_element = element.bytes_per_leaf;
  return figures;
}

}  // namespace rad::cli
