// Light maps of a solution: the pages, what a model shows of them, and the files beside it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/options.h"
#include "geom/lattice.h"
#include "mesh/display_mesh.h"
#include "mesh/radiosity_field.h"
#include "report/repair_report.h"
#include "scene/light_map.h"

namespace rad::cli {

/// A file to be written beside the model.
struct FileBeside {
  std::filesystem::path path;
  std::shared_ptr<const std::string> bytes;
};

struct BakedLightMap {
  std::string problem;  ///< why there is none; then the rest is empty
  scene::LightMap map;
  std::vector<FileBeside> files;  ///< none under --dry-run
  report::LightMapFigures figures;
};

/// What light maps are made of.
struct SolvedMesh {
  const mesh::RadiosityMesh& mesh;
  const mesh::RadiosityField& field;
  const mesh::DisplayMesh& display;
  const geom::Lattice& lattice;
  const scene::Scene& scene;  ///< display_scene() of the display mesh
  double finest_element = 0;  ///< longest edge of elements where shadows end, file units
  double exposure = 1;        ///< m²/W
};

/// Bakes the pages that the command asks for; `progress` hears what is being done.
BakedLightMap bake_light_map(const FixCommand& command, const SolvedMesh& solved,
                             const std::function<void(const std::string&)>& progress);

/// The atlas beside a model: OUT.atlas.json for OUT.glb.
std::filesystem::path atlas_path(const std::string& output);

}  // namespace rad::cli
