#include "mesh/hemicube.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

namespace rad::mesh {
namespace {

struct Axes {
  dvec3 right, up, forward;
};

std::array<Axes, 5> faces_over(const dvec3& normal) {
  const dvec3 aside = std::abs(normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
  const dvec3 u = glm::normalize(glm::cross(aside, normal)), v = glm::cross(normal, u);
  return {{{u, v, normal}, {v, normal, u}, {-v, normal, -u}, {-u, normal, v}, {u, normal, -v}}};
}

// The leaf of a patch that a place lies in: at every step the child whose corner it is nearest to inside.
ElementId leaf_at(const ElementMesh& mesh, PatchId patch, const dvec3& place) {
  const dvec3& normal = mesh.source(patch).normal;
  const auto inside = [&](ElementId element) {
    const Corners corners = mesh.corners(element);
    double least = INFINITY;
    for (std::uint32_t i = 0; i < corners.count; ++i) {
      const auto at = [&](std::uint32_t k) {
        return geom::as_vector(mesh.points()[mesh.point_of(corners.node[k % corners.count])]);
      };
      const dvec3 edge = at(i + 1) - at(i);
      least = std::min(least, glm::dot(glm::cross(edge, place - at(i)), normal) / glm::length(edge));
    }
    return least;
  };
  ElementId element = patch;
  while (!mesh.is_leaf(element)) {
    const ElementId first = mesh.first_child(element);
    element = first;
    for (ElementId slot = 1; slot < 4; ++slot) {
      if (inside(first + slot) > inside(element)) element = first + slot;
    }
  }
  return element;
}

}  // namespace

Hemicube hemicube(const ElementMesh& mesh, const PatchRays& rays, const LightSample& light, std::uint32_t resolution) {
  Hemicube cube{resolution, {}, {}};
  cube.item.assign(std::size_t{cube.width()} * resolution, kNoElement);
  cube.depth.assign(cube.item.size(), 0);
  const std::array<Axes, 5> faces = faces_over(light.normal);
  tbb::parallel_for(std::uint32_t{0}, resolution, [&](std::uint32_t row) {
    for (std::uint32_t column = 0; column < cube.width(); ++column) {
      const auto& [right, up, forward] = faces[column / resolution];
      const double x = 2 * (column % resolution + 0.5) / resolution - 1, y = 2 * (row + 0.5) / resolution - 1;
      if (column >= resolution && y < 0) continue;  // below the plane of the emitter
      const dvec3 way = glm::normalize(forward + right * x + up * y);
      const auto hit = rays.nearest(light.place, way);
      if (!hit) continue;
      cube.item[cube.at(column, row)] = leaf_at(mesh, hit->patch, light.place + way * hit->distance);
      cube.depth[cube.at(column, row)] = static_cast<float>(hit->distance * glm::dot(way, forward));
    }
  });
  return cube;
}

void mark_steps(const Hemicube& cube, std::vector<std::uint8_t>& marked) {
  const auto compare = [&](std::size_t a, std::size_t b) {
    if (cube.item[a] == cube.item[b] || cube.item[a] == kNoElement || cube.item[b] == kNoElement) return;
    const std::size_t nearer = cube.depth[a] < cube.depth[b] ? a : b, farther = nearer == a ? b : a;
    // One pixel on a plane at 60° to the view changes the depth by so much of it.
    const double slack = 2 * std::sqrt(3.0) / cube.resolution * cube.depth[nearer];
    if (cube.depth[farther] - cube.depth[nearer] > 2 * slack) marked[cube.item[farther]] = 1;
  };
  for (std::uint32_t row = 0; row < cube.resolution; ++row) {
    for (std::uint32_t column = 0; column < cube.width(); ++column) {
      const bool last = column % cube.resolution + 1 == cube.resolution;
      if (!last) compare(cube.at(column, row), cube.at(column + 1, row));
      if (row + 1 < cube.resolution) compare(cube.at(column, row), cube.at(column, row + 1));
    }
  }
}

std::string write_hemicube(const Hemicube& cube, const std::string& path) {
  const std::string draft = path + ".part";
  try {
    Imf::Header header(static_cast<int>(cube.width()), static_cast<int>(cube.resolution));
    header.channels().insert("item", Imf::Channel(Imf::UINT));
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer buffer;
    const auto slice = [&](Imf::PixelType type, const void* data) {
      return Imf::Slice(type, static_cast<char*>(const_cast<void*>(data)), 4, std::size_t{4} * cube.width());
    };
    buffer.insert("item", slice(Imf::UINT, cube.item.data()));
    buffer.insert("Z", slice(Imf::FLOAT, cube.depth.data()));
    {
      Imf::OutputFile file(draft.c_str(), header);
      file.setFrameBuffer(buffer);
      file.writePixels(static_cast<int>(cube.resolution));
    }
    std::filesystem::rename(draft, path);
    return {};
  } catch (const std::exception& error) {
    std::error_code ignored;
    std::filesystem::remove(draft, ignored);
    return path + ": " + error.what();
  }
}

}  // namespace rad::mesh
