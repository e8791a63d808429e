// A case of the reference radiosity solutions: its faces as grids, its probes, its tolerances.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "readers/reader.h"
#include "tests/support/field_probe.h"
#include "tests/support/grid_mesh.h"

namespace rad::tests {

struct Probe {
  dvec3 point, normal, radiosity;
};

struct Score {
  double mean = 0, p95 = 0, largest = 0;
  std::size_t probes = 0, missing = 0;
};

struct ReferenceCase {
  scene::Scene scene;
  std::vector<Probe> probes;
  Score tolerance;
  dvec3 floor{0, 0, 0};
  double diagonal = 0;
};

inline std::vector<Probe> read_probes(const std::filesystem::path& path) {
  std::vector<Probe> probes;
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    Probe probe;
    for (dvec3* vector : {&probe.point, &probe.normal, &probe.radiosity}) fields >> vector->x >> vector->y >> vector->z;
    if (fields) probes.push_back(probe);
  }
  return probes;
}

inline ReferenceCase read_case(const std::filesystem::path& folder) {
  ReferenceCase result;
  result.scene = readers::read_file(folder / "scene.obj").scene;
  result.probes = read_probes(folder / "expected.csv");
  std::ifstream stream(folder / "case.json");
  const nlohmann::json json = nlohmann::json::parse(stream);
  const auto& tolerance = json.at("tolerance");
  result.tolerance = {tolerance.at("mean"), tolerance.at("p95"), tolerance.at("max")};
  for (int channel = 0; channel < 3; ++channel) result.floor[channel] = json.at("floor").at(channel);
  dvec3 low(1e300), high(-1e300);
  for (const dvec3& vertex : result.scene.vertices) low = glm::min(low, vertex), high = glm::max(high, vertex);
  result.diagonal = glm::length(high - low);
  return result;
}

/// Every face, a triangle or quadrilateral, on its own: patches of at most `patch_size`, each split × split elements.
inline mesh::RadiosityMesh grid_of(const ReferenceCase& given, double patch_size, int split) {
  GridMesh grid(given.diagonal);
  for (const scene::Face& face : given.scene.faces) {
    const auto ids = given.scene.corners_of(given.scene.loops_of(face)[0]);
    const auto at = [&](std::size_t i) { return given.scene.vertices[ids[i % ids.size()]]; };
    const auto pieces = [&](std::size_t edge) {
      return std::max(1, int(std::ceil(glm::length(at(edge + 1) - at(edge)) / patch_size - 1e-9)));
    };
    if (ids.size() == 4) {
      const int u = std::max(pieces(0), pieces(2)), v = std::max(pieces(1), pieces(3));
      grid.add_quadrilateral({at(0), at(1), at(2), at(3)}, u, v, split, face.material);
    } else {
      grid.add_triangle({at(0), at(1), at(2)}, std::max({pieces(0), pieces(1), pieces(2)}), split, face.material);
    }
  }
  return grid.mesh;
}

inline Score score_of(const ReferenceCase& given, const mesh::RadiosityMesh& mesh, const mesh::RadiosityField& field) {
  Score score;
  std::vector<double> errors;
  for (const Probe& probe : given.probes) {
    const auto got = radiosity_at(mesh, field, probe.point, probe.normal, 1e-5 * given.diagonal);
    if (!got) {
      ++score.missing;
      continue;
    }
    double error = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const double scale = std::max(std::abs(probe.radiosity[channel]), given.floor[channel]);
      error = std::max(error, std::abs((*got)[channel] - probe.radiosity[channel]) / (scale > 0 ? scale : 1));
    }
    errors.push_back(error);
    score.mean += error;
  }
  score.probes = errors.size();
  if (errors.empty()) return score;
  score.mean /= double(errors.size());
  std::sort(errors.begin(), errors.end());
  score.p95 = errors[std::size_t(std::ceil(0.95 * double(errors.size() - 1)))];
  score.largest = errors.back();
  return score;
}

}  // namespace rad::tests
