// What writing a solution costs: 16 walls with 1 060 896 elements as GLB, with Draco, and as pages of light.
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "bake/display_scene.h"
#include "bake/light_map.h"
#include "bake/vertex_light.h"
#include "writers/registry.h"

namespace {

using namespace rad;
namespace fs = std::filesystem;

constexpr std::uint32_t kWalls = 16, kColumns = 258, kRows = 257;  // elements along each wall
constexpr std::int32_t kStep = 1 << 10;                            // pitches along an element
constexpr double kPitch = 0x1p-16;                                 // file units

struct Solution {
  mesh::RadiosityMesh mesh;
  mesh::RadiosityField field;
  mesh::DisplayMesh display;
  geom::Lattice lattice{kPitch, {0, 0, 0}};
};

// Smooth, with the edge of a shadow across it.
geom::dvec3 light_at(const geom::dvec3& at) {
  const double value = 3 + 2 * std::sin(0.8 * at.x + at.z) + 5 / (1 + std::exp(-9 * (at.x - at.y)));
  return value * geom::dvec3(1, 0.9, 0.7);
}

void add_wall(Solution& solution, std::uint32_t wall) {
  const auto first = static_cast<mesh::NodeId>(solution.mesh.nodes.size());
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const geom::LatticePoint point{static_cast<std::int32_t>(column) * kStep, static_cast<std::int32_t>(row) * kStep,
                                     static_cast<std::int32_t>(wall) * 64 * kStep};
      const auto node = static_cast<mesh::NodeId>(solution.mesh.nodes.size());
      const geom::dvec3 position = solution.lattice.position(point);
      solution.mesh.nodes.push_back({.position = position, .normal = {0, 0, 1}, .inward = {0, 0, 0}});
      solution.display.vertices.push_back({.point = point, .node = {node, node}});
      solution.field.radiosity.push_back(light_at(position));
    }
  }
  const auto at = [&](std::uint32_t column, std::uint32_t row) { return first + row * (kColumns + 1) + column; };
  const mesh::Corners whole{{at(0, 0), at(kColumns, 0), at(kColumns, kRows), at(0, kRows)}, 4};
  solution.mesh.patches.push_back({whole, 0, {0, 0, 1}, kColumns * kRows * kStep * kPitch * kStep * kPitch});
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const mesh::Corners corners{{at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)},
                                  4};
      solution.mesh.elements.push_back({corners, wall});
      solution.display.faces.push_back({.corner = corners.node, .count = 4, .patch = wall});
    }
  }
}

template <typename Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void write(const writers::Output& output, const fs::path& path) {
  std::string problem;
  const double taken = seconds([&] { problem = writers::writer_for(path)->write(output, path).problem; });
  if (!problem.empty()) throw std::runtime_error(problem);
  fmt::print("  {:<12}{:6.2f} s {:8.1f} MB\n", path.filename().string(), taken,
             1e-6 * static_cast<double>(fs::file_size(path)));
}

void bake_pages(const Solution& solution, std::span<const scene::Material> materials, double exposure) {
  std::optional<bake::Atlas> atlas;
  const double texel = kColumns * kStep * kPitch / 1012;  // four walls and their gutters along a page
  const double laid_out = seconds([&] { atlas = bake::lay_out_atlas(solution.mesh, {.texel = texel}); });
  if (!atlas->problem.empty()) throw std::runtime_error(atlas->problem);
  const bake::LightMapBaker baker(*atlas, solution.mesh, materials, solution.field,
                                  {.exposure = exposure, .software = "bench_write"});
  for (std::uint32_t page = 0; page < atlas->pages.size(); ++page) {
    std::size_t bytes = 0;
    const double taken = seconds([&] {
      const bake::BakedPage baked = baker.bake(page);
      bytes = baked.exr.size() + baked.png.size();
    });
    fmt::print("  page {} of {} x {}: {:.2f} s {:8.1f} MB (layout of all: {:.2f} s)\n", page, atlas->pages[page].width,
               atlas->pages[page].height, taken, 1e-6 * static_cast<double>(bytes), laid_out);
  }
}

}  // namespace

int main() {
  const std::size_t threads = std::min(2U, std::thread::hardware_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Solution solution;
  for (std::uint32_t wall = 0; wall < kWalls; ++wall) add_wall(solution, wall);
  const scene::Scene origin = scene::empty_scene("walls", "bench");
  const scene::VertexLight light =
      bake::vertex_light(solution.display, solution.mesh, origin.materials, solution.field, std::nullopt);
  fmt::print("{} elements, {} nodes, {} threads\n", solution.mesh.elements.size(), solution.mesh.nodes.size(), threads);
  std::optional<scene::Scene> shown;
  fmt::print("  {:<12}{:6.2f} s\n", "scene",
             seconds([&] { shown = bake::display_scene(solution.display, solution.lattice, origin); }));
  const fs::path folder = fs::temp_directory_path() / "bench_write";
  fs::create_directories(folder);
  const writers::Output output{
      .scene = *shown, .light = &light, .lattice = scene::RecordedLattice{solution.lattice, 64 * kPitch}};
  for (const char* name : {"out.glb", "out.draco.glb", "out.ply"}) write(output, folder / name);
  bake_pages(solution, origin.materials, light.exposure);
  fs::remove_all(folder);
}
