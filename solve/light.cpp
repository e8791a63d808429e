#include "solve/light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rad::solve {
namespace {

constexpr const char* kChannelName[] = {"red", "green", "blue"};

std::string problem_of(const scene::Material& material) {
  for (int channel = 0; channel < 3; ++channel) {
    const double reflectance = material.reflectance[channel];
    const double emission = material.emission[channel];
    if (!(reflectance >= 0 && reflectance < 1)) {
      return fmt::format("material '{}': {} reflectance {} is not from 0 to below 1", material.name,
                         kChannelName[channel], reflectance);
    }
    if (!(emission >= 0) || !std::isfinite(emission)) {
      return fmt::format("material '{}': {} emission {} is not a finite number from 0 up", material.name,
                         kChannelName[channel], emission);
    }
  }
  return {};
}

}  // namespace

dvec3 exitance(const scene::Material& material) {
  const bool luminance = material.emission_unit == scene::Material::EmissionUnit::Luminance;
  return luminance ? material.emission * std::numbers::pi : material.emission;
}

bool has_emitters(const mesh::RadiosityMesh& mesh, std::span<const scene::Material> materials) {
  return std::any_of(mesh.patches.begin(), mesh.patches.end(),
                     [&](const mesh::Patch& patch) { return patch.area > 0 && materials[patch.material].emits(); });
}

std::string light_problem(std::span<const scene::Material> materials) {
  for (const scene::Material& material : materials) {
    std::string problem = problem_of(material);
    if (!problem.empty()) return problem;
  }
  return {};
}

}  // namespace rad::solve
