// Radiosity meshes with solutions, made by hand, and what a light map is asked for.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "bake/light_page.h"

namespace rad::bake {

/// Patches of square grids of elements, whose nodes are made where they are first named.
struct MappedScene {
  mesh::RadiosityMesh mesh;
  mesh::RadiosityField field;

  mesh::NodeId add_node(const dvec3& position, double value) {
    mesh.nodes.push_back({.position = position, .normal = {0, 0, 1}, .inward = {0, 0, 0}});
    field.radiosity.push_back(value * dvec3(1, 0.5, 0.25));
    return static_cast<mesh::NodeId>(mesh.nodes.size() - 1);
  }

  /// `nodes` by rows of `columns`, each row from the left as seen with the next row above it.
  void add_patch(const std::vector<mesh::NodeId>& nodes, std::uint32_t columns, scene::MaterialId material = 0) {
    const auto rows = static_cast<std::uint32_t>(nodes.size()) / columns;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return nodes[j * columns + i]; };
    const mesh::Corners corners{{at(0, 0), at(columns - 1, 0), at(columns - 1, rows - 1), at(0, rows - 1)}, 4};
    const dvec3& from = mesh.nodes[corners.node[0]].position;
    const dvec3 doubled =
        glm::cross(mesh.nodes[corners.node[1]].position - from, mesh.nodes[corners.node[3]].position - from);
    const auto patch = static_cast<mesh::PatchId>(mesh.patches.size());
    mesh.patches.push_back({corners, material, glm::normalize(doubled), 0});
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
      for (std::uint32_t i = 0; i + 1 < columns; ++i) {
        mesh.elements.push_back({{{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, 4}, patch});
      }
    }
  }
};

/// Light with a shadow across it: steep where the shadow ends, and never dark.
inline double shadowed(const dvec3& at) {
  return 20 + 8 * std::sin(1.3 * at.x + 0.4 * at.z) + 60 / (1 + std::exp(-6 * (at.x + 0.7 * at.y + 0.3 * at.z)));
}

/// The side of a cone cut off: `facets` trapezoids with common nodes at their slanting edges, each of n × n elements.
inline MappedScene cone(int facets, int n) {
  MappedScene scene;
  std::vector<std::vector<mesh::NodeId>> seam(static_cast<std::size_t>(facets));
  const auto ring = [&](int facet, double height) {
    const double angle = 2 * std::numbers::pi * facet / facets, radius = 2 - 0.6 * height;
    return dvec3(radius * std::cos(angle), radius * std::sin(angle), height);
  };
  const auto node = [&](const dvec3& at) { return scene.add_node(at, shadowed(at)); };
  for (int facet = 0; facet < facets; ++facet) {
    for (int j = 0; j <= n; ++j) seam[static_cast<std::size_t>(facet)].push_back(node(ring(facet, 2.0 * j / n)));
  }
  for (int facet = 0; facet < facets; ++facet) {
    const auto& left = seam[static_cast<std::size_t>(facet)];
    const auto& right = seam[static_cast<std::size_t>((facet + 1) % facets)];
    std::vector<mesh::NodeId> nodes;
    for (int j = 0; j <= n; ++j) {
      const dvec3 from = ring(facet, 2.0 * j / n), to = ring(facet + 1, 2.0 * j / n);
      nodes.push_back(left[static_cast<std::size_t>(j)]);
      for (int i = 1; i < n; ++i) nodes.push_back(node(from + (to - from) * (double(i) / n)));
      nodes.push_back(right[static_cast<std::size_t>(j)]);
    }
    scene.add_patch(nodes, static_cast<std::uint32_t>(n + 1));
  }
  return scene;
}

/// Bilinear interpolation between the four texels around a point of the page: (i, j) is the centre of a texel.
inline dvec3 bilinear(const LightPage& page, const dvec2& at) {
  const double column = std::floor(at.x), row = std::floor(at.y);
  dvec3 sum(0);
  for (const int down : {0, 1}) {
    for (const int right : {0, 1}) {
      const double weight =
          (right == 1 ? at.x - column : 1 - at.x + column) * (down == 1 ? at.y - row : 1 - at.y + row);
      const auto i = static_cast<std::size_t>(column) + static_cast<std::size_t>(right);
      const auto j = static_cast<std::size_t>(row) + static_cast<std::size_t>(down);
      const float* texel = &page.radiosity[3 * (j * page.width + i)];
      sum += weight * dvec3(texel[0], texel[1], texel[2]);
    }
  }
  return sum;
}

/// What a viewer sees of a chart at a position in it.
inline dvec3 seen(const Atlas& atlas, const std::vector<LightPage>& pages, std::uint32_t chart, const dvec3& position) {
  const LightPage& page = pages[atlas.places[chart].page];
  return bilinear(page, atlas.page_coordinates(chart, position) * dvec2(page.width, page.height) - 0.5);
}

inline std::vector<LightPage> painted(const Atlas& atlas, const MappedScene& scene) {
  std::vector<LightPage> pages;
  for (std::uint32_t page = 0; page < atlas.pages.size(); ++page) {
    pages.push_back(paint_page(atlas, page, scene.mesh, scene.field));
  }
  return pages;
}

/// The integral of what the nodes say, by Gauss's rule of two points along each axis: exact for bilinear functions on
/// flat quadrilaterals.
inline dvec3 integral_over_nodes(const MappedScene& scene) {
  const double near = (1 - 1 / std::sqrt(3.0)) / 2;
  dvec3 sum(0);
  for (const mesh::Element& element : scene.mesh.elements) {
    std::array<dvec3, 4> p, b;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = scene.mesh.nodes[element.corners.node[i]].position;
      b[i] = scene.field.radiosity[element.corners.node[i]];
    }
    for (const double s : {near, 1 - near}) {
      for (const double t : {near, 1 - near}) {
        const dvec3 along_s = (p[1] - p[0]) * (1 - t) + (p[2] - p[3]) * t;
        const dvec3 along_t = (p[3] - p[0]) * (1 - s) + (p[2] - p[1]) * s;
        const dvec3 value = (b[0] * (1 - s) + b[1] * s) * (1 - t) + (b[3] * (1 - s) + b[2] * s) * t;
        sum += value * glm::length(glm::cross(along_s, along_t)) / 4.0;
      }
    }
  }
  return sum;
}

/// The same of the map: texels by their share in the charts.
inline dvec3 integral_over_map(const Atlas& atlas, const std::vector<LightPage>& pages) {
  dvec3 sum(0);
  for (const ChartPlace& place : atlas.places) {
    const LightPage& page = pages[place.page];
    for (std::uint32_t y = place.y; y < place.y + place.rows; ++y) {
      for (std::uint32_t x = place.x; x < place.x + place.columns; ++x) {
        const std::size_t i = std::size_t{y} * page.width + x;
        const float* texel = &page.radiosity[3 * i];
        sum += dvec3(texel[0], texel[1], texel[2]) * (page.coverage[i] * place.texel.x * place.texel.y);
      }
    }
  }
  return sum;
}

}  // namespace rad::bake
