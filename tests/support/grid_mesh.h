// Radiosity meshes of uniform grids, made by hand: every face on its own, with nodes of its own.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <span>
#include <vector>

#include "mesh/radiosity_mesh.h"

namespace rad::tests {

using geom::dvec3;

class GridMesh {
 public:
  mesh::RadiosityMesh mesh;

  /// `diagonal` of the model that is to be built gives pitch and tolerance: 2^-22 and 1e-5 of it.
  explicit GridMesh(double diagonal) {
    mesh.pitch = 0x1p-22 * diagonal;
    mesh.tolerance = 1e-5 * diagonal;
  }

  /// A convex quadrilateral, counter-clockwise from the front, as u × v patches of `split` × `split` elements.
  void add_quadrilateral(const std::array<dvec3, 4>& corner, int u, int v, int split, scene::MaterialId material) {
    const int columns = u * split + 1;
    const auto first = start_face();
    for (int j = 0; j <= v * split; ++j) {
      for (int i = 0; i <= u * split; ++i) {
        const double s = double(i) / (u * split), t = double(j) / (v * split);
        add_node(corner[0] * ((1 - s) * (1 - t)) + corner[1] * (s * (1 - t)) + corner[2] * (s * t) +
                 corner[3] * ((1 - s) * t));
      }
    }
    const auto cell = [&](int i, int j, int size) {
      const auto at = [&](int a, int b) { return first + static_cast<mesh::NodeId>(b * columns + a); };
      return mesh::Corners{{at(i, j), at(i + size, j), at(i + size, j + size), at(i, j + size)}, 4};
    };
    for (int j = 0; j < v * split; j += split) {
      for (int i = 0; i < u * split; i += split) {
        add_patch(cell(i, j, split), material);
        for (int b = j; b < j + split; ++b) {
          for (int a = i; a < i + split; ++a) add_element(cell(a, b, 1));
        }
      }
    }
    finish_face(first);
  }

  /// A triangle as n² patches of split² elements.
  void add_triangle(const std::array<dvec3, 3>& corner, int n, int split, scene::MaterialId material) {
    const int size = n * split;
    const auto first = start_face();
    std::map<std::array<int, 2>, mesh::NodeId> node;
    for (int j = 0; j <= size; ++j) {
      for (int i = 0; i + j <= size; ++i) {
        node[{i, j}] = static_cast<mesh::NodeId>(mesh.nodes.size());
        add_node(corner[0] + (corner[1] - corner[0]) * (double(i) / size) +
                 (corner[2] - corner[0]) * (double(j) / size));
      }
    }
    const auto piece = [&](int i, int j, int step) {
      return mesh::Corners{{node.at({i, j}), node.at({i + step, j}), node.at({i, j + step}), 0}, 3};
    };
    const auto patch = [&](int i, int j, int step) {
      add_patch(piece(i, j, step), material);
      const int unit = step / split;
      for (int b = 0; b < split; ++b) {
        for (int a = 0; a + b < split; ++a) {
          add_element(piece(i + a * unit, j + b * unit, unit));
          if (a + b + 1 < split) add_element(piece(i + (a + 1) * unit, j + (b + 1) * unit, -unit));
        }
      }
    };
    for (int j = 0; j < size; j += split) {
      for (int i = 0; i + j < size; i += split) {
        patch(i, j, split);
        if (i + j + split < size) patch(i + split, j + split, -split);
      }
    }
    finish_face(first);
  }

  /// A rectangle from `origin` along two edges that turn counter-clockwise seen from the front.
  void add_rectangle(dvec3 origin, dvec3 along, dvec3 up, int u, int v, int split, scene::MaterialId material) {
    add_quadrilateral({origin, origin + along, origin + along + up, origin + up}, u, v, split, material);
  }

  /// An axis-parallel box whose fronts point inward or outward, n × n patches a face.
  void add_box(dvec3 low, dvec3 high, bool inward, int n, int split, scene::MaterialId material) {
    const dvec3 size = high - low;
    const dvec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
    const auto face = [&](dvec3 origin, dvec3 a, dvec3 b) {
      add_rectangle(origin, inward ? a : b, inward ? b : a, n, n, split, material);
    };
    face(low, x, y), face(low, y, z), face(low, z, x);
    face(low + z, y, x), face(low + x, z, y), face(low + y, x, z);
  }

 private:
  mesh::NodeId start_face() {
    first_element_ = mesh.elements.size();
    return static_cast<mesh::NodeId>(mesh.nodes.size());
  }

  void add_node(const dvec3& position) { mesh.nodes.push_back({position, dvec3(0), dvec3(0), 0}); }

  void add_patch(const mesh::Corners& corners, scene::MaterialId material) {
    const auto at = [&](int i) { return mesh.nodes[corners.node[i]].position; };
    dvec3 twice = glm::cross(at(1) - at(0), at(2) - at(0));
    if (corners.count == 4) twice += glm::cross(at(2) - at(0), at(3) - at(0));
    mesh.patches.push_back({corners, material, glm::normalize(twice), glm::length(twice) / 2});
  }

  void add_element(const mesh::Corners& corners) {
    mesh.elements.push_back({corners, static_cast<mesh::PatchId>(mesh.patches.size() - 1)});
  }

  /// Normals, element sizes and inward directions: at a node in the middle the ways along its edges cancel out.
  void finish_face(mesh::NodeId first) {
    std::map<std::array<mesh::NodeId, 2>, int> uses;
    for (std::size_t e = first_element_; e < mesh.elements.size(); ++e) {
      const auto corners = mesh.elements[e].corners.all();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const mesh::NodeId a = corners[i], b = corners[(i + 1) % corners.size()];
        ++uses[{std::min(a, b), std::max(a, b)}];
        mesh.nodes[a].normal = mesh.patches.back().normal;
      }
    }
    std::map<mesh::NodeId, bool> on_border;
    for (const auto& [edge, count] : uses) {
      const dvec3 way = mesh.nodes[edge[1]].position - mesh.nodes[edge[0]].position;
      for (int end = 0; end < 2; ++end) {
        mesh::Node& node = mesh.nodes[edge[end]];
        node.inward += glm::normalize(way) * (end == 0 ? 1.0 : -1.0);
        node.element_size = node.element_size > 0 ? std::min(node.element_size, glm::length(way)) : glm::length(way);
        on_border[edge[end]] |= count == 1;
      }
    }
    for (mesh::NodeId node = first; node < mesh.nodes.size(); ++node) {
      dvec3& inward = mesh.nodes[node].inward;
      inward = on_border[node] ? glm::normalize(inward) : dvec3(0);
    }
  }

  std::size_t first_element_ = 0;
};

/// A diffuse material.
inline scene::Material material(dvec3 reflectance, dvec3 emission = dvec3(0)) {
  scene::Material result;
  result.reflectance = reflectance;
  result.emission = emission;
  return result;
}

}  // namespace rad::tests
