#include "bake/vertex_light.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "bake/legend.h"

namespace rad::bake {
namespace {

using geom::dvec3;
using mesh::Element;
using mesh::NodeId;
using mesh::RadiosityField;
using mesh::RadiosityMesh;

enum class Counted { NonEmitters, All };

double area(const RadiosityMesh& mesh, const Element& element) {
  const auto corners = element.corners.all();
  const dvec3& from = mesh.nodes[corners[0]].position;
  dvec3 doubled{0, 0, 0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    doubled += glm::cross(mesh.nodes[corners[i]].position - from, mesh.nodes[corners[i + 1]].position - from);
  }
  return glm::length(doubled) / 2;
}

std::vector<double> node_areas(const RadiosityMesh& mesh, std::span<const scene::Material> materials, Counted counted) {
  std::vector<double> areas(mesh.nodes.size(), 0);
  for (const Element& element : mesh.elements) {
    if (counted == Counted::NonEmitters && materials[mesh.patches[element.patch].material].emits()) continue;
    const double share = area(mesh, element) / element.corners.count;
    for (const NodeId node : element.corners.all()) areas[node] += share;
  }
  return areas;
}

struct WeightedLuminance {
  double luminance = 0;
  double area = 0;
};

/// The luminance to expose for; zero where all that counts is dark.
double white_luminance(const RadiosityMesh& mesh, std::span<const scene::Material> materials,
                       const RadiosityField& field, Counted counted) {
  const std::vector<double> areas = node_areas(mesh, materials, counted);
  std::vector<WeightedLuminance> values;
  double total = 0;
  for (NodeId node = 0; node < mesh.nodes.size(); ++node) {
    if (areas[node] <= 0) continue;
    values.push_back({luminance(field.radiosity[node]), areas[node]});
    total += areas[node];
  }
  if (values.empty()) return 0;
  std::stable_sort(values.begin(), values.end(),
                   [](const auto& a, const auto& b) { return a.luminance < b.luminance; });
  double below = 0;
  for (const WeightedLuminance& value : values) {
    below += value.area;
    if (below >= kExposurePercentile * total) {
      return value.luminance > 0 ? value.luminance : values.back().luminance;
    }
  }
  return values.back().luminance;
}

}  // namespace

double automatic_exposure(const RadiosityMesh& mesh, std::span<const scene::Material> materials,
                          const RadiosityField& field) {
  double white = white_luminance(mesh, materials, field, Counted::NonEmitters);
  if (white <= 0) white = white_luminance(mesh, materials, field, Counted::All);
  return white > 0 ? kWhitePoint / white : 1;
}

scene::VertexLight vertex_light(const mesh::DisplayMesh& display, const RadiosityMesh& mesh,
                                std::span<const scene::Material> materials, const RadiosityField& field,
                                std::optional<double> exposure, scene::DisplayCurve curve) {
  scene::VertexLight light;
  light.curve = curve;
  light.exposure = exposure ? *exposure : automatic_exposure(mesh, materials, field);
  if (!exposure && curve == scene::DisplayCurve::FalseColour) light.exposure = 1 / round_above(1 / light.exposure);
  light.radiosity.reserve(display.vertices.size());
  light.colour.reserve(display.vertices.size());
  std::size_t clamped = 0;
  for (const mesh::DisplayVertex& vertex : display.vertices) {
    const dvec3& from = field.radiosity[vertex.node[0]];
    const dvec3& to = field.radiosity[vertex.node[1]];
    light.radiosity.push_back((1 - vertex.share) * from + vertex.share * to);
    const dvec3 shown = scene::curved(curve, light.exposure * light.radiosity.back());
    if (shown.x > 1 || shown.y > 1 || shown.z > 1) ++clamped;
    light.colour.push_back(glm::clamp(shown, 0.0, 1.0));
  }
  if (!display.vertices.empty()) {
    light.clamped_share = static_cast<double>(clamped) / static_cast<double>(display.vertices.size());
  }
  return light;
}

}  // namespace rad::bake
