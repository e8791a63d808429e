// What lies where on the pages of a light map, as JSON.
#pragma once

#include <string>
#include <vector>

#include "bake/atlas.h"
#include "bake/light_map.h"
#include "mesh/display_mesh.h"
#include "scene/scene.h"

namespace rad::report {

/// Version of the shape of atlas.json, semantic versioning.
inline constexpr std::string_view kAtlasSchemaVersion = "2.0.0";

struct AtlasRecord {
  const bake::Atlas& atlas;
  const mesh::DisplayMesh& display;  ///< its faces say whose a chart is
  const scene::Scene& scene;         ///< names of objects, groups and materials
  const bake::LightMapOptions& options;
  bake::ExrPrecision precision = bake::ExrPrecision::Half;
  const std::vector<double>& white;  ///< of each chart, W/m²
  double clamped_share = 0;
  std::string model;  ///< file names, without folders
  std::vector<std::string> exr_pages;
  std::vector<std::string> png_pages;
};

/// As atlas.schema.json has it. One line for each page, material and chart.
std::string atlas_json(const AtlasRecord& record);

}  // namespace rad::report
