#include "mesh/light_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace rad::mesh {
namespace {

// Corners are drawn to the middle by this share, so that they do not lie in the plane of what the emitter is set into.
constexpr double kInset = 0.02;

struct Emitter {
  std::uint32_t face = 0;
  double power = 0;
  dvec3 normal;
  std::vector<dvec3> points;
};

std::vector<Emitter> emitters_of(const ElementMesh& mesh, std::span<const scene::Material> materials) {
  std::map<std::uint32_t, Emitter> by_face;
  for (PatchId patch = 0; patch < mesh.patch_count(); ++patch) {
    const PatchSource& source = mesh.source(patch);
    if (source.material >= materials.size() || !materials[source.material].emits()) continue;
    Emitter& emitter = by_face[source.face];
    const dvec3& light = materials[source.material].emission;
    emitter = {source.face, source.face_area * (light.x + light.y + light.z), source.normal, std::move(emitter.points)};
    const Corners corners = mesh.corners(patch);
    for (const NodeId node : corners.all())
      emitter.points.push_back(geom::as_vector(mesh.points()[mesh.point_of(node)]));
  }
  std::vector<Emitter> emitters;
  for (auto& [face, emitter] : by_face) emitters.push_back(std::move(emitter));
  std::sort(emitters.begin(), emitters.end(),
            [](const Emitter& a, const Emitter& b) { return std::tie(b.power, a.face) < std::tie(a.power, b.face); });
  return emitters;
}

dvec3 middle_of(const std::vector<dvec3>& points) {
  dvec3 low = points.front(), high = points.front();
  for (const dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return (low + high) * 0.5;
}

void add_samples(const Emitter& emitter, double lift, std::vector<LightSample>& samples) {
  const dvec3 middle = middle_of(emitter.points);
  const dvec3 aside = std::abs(emitter.normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
  const dvec3 u = glm::normalize(glm::cross(aside, emitter.normal)), v = glm::cross(emitter.normal, u);
  const auto add = [&](const dvec3& place) {
    samples.push_back({place + (middle - place) * kInset + emitter.normal * lift, emitter.normal});
  };
  add(middle);
  for (const dvec3& way : {u + v, v - u, -u - v, u - v}) {
    add(*std::max_element(emitter.points.begin(), emitter.points.end(),
                          [&](const dvec3& a, const dvec3& b) { return glm::dot(a, way) < glm::dot(b, way); }));
  }
}

}  // namespace

std::vector<LightSample> light_samples(const ElementMesh& mesh, std::span<const scene::Material> materials,
                                       std::size_t most_emitters) {
  std::vector<Emitter> emitters = emitters_of(mesh, materials);
  emitters.resize(std::min(emitters.size(), most_emitters));
  std::vector<LightSample> samples;
  for (const Emitter& emitter : emitters) {
    add_samples(emitter, 2 * static_cast<double>(mesh.tolerance().pitches), samples);
  }
  return samples;
}

}  // namespace rad::mesh
