// The element library: element splits per second, one element at a time and in batches, and bytes an element.
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <chrono>
#include <thread>

#include "mesh/element_mesh.h"

namespace {

using namespace rad;

// n by n squares of one surface.
mesh::ElementPatches sheet(std::uint32_t n) {
  mesh::ElementPatches patches;
  patches.tolerance.pitches = 1;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      patches.node_point.push_back(static_cast<std::uint32_t>(patches.points.size()));
      patches.points.push_back({static_cast<std::int32_t>(k) << 12, static_cast<std::int32_t>(i) << 12, 0});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k;
      patches.corners.push_back({{a, a + 1, a + n + 2, a + n + 1}, 4});
      patches.sources.push_back({0, {0, 0, 1}, 1});
    }
  }
  return patches;
}

void measure(std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  mesh::ElementMesh elements(sheet(256));
  const std::size_t patches = elements.patch_count();
  const auto start = std::chrono::steady_clock::now();
  for (int round = 0; round < 3; ++round) elements.refine(elements.leaves());
  // Then along a line: balance divides much more than is asked for.
  for (int round = 0; round < 4; ++round) {
    std::vector<mesh::ElementId> chosen;
    for (const mesh::ElementId leaf : elements.leaves()) {
      const geom::LatticePoint& p = elements.points()[elements.point_of(elements.corners(leaf).node[0])];
      if (std::abs(p.x - p.y) < 2048) chosen.push_back(leaf);
    }
    elements.refine(chosen);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto splits = static_cast<double>(elements.element_count() - patches) / 4;
  const auto leaves = static_cast<double>(elements.leaves().size());
  fmt::print("{} threads: {:.0f} splits, {:.2f} million a second; {:.1f} bytes a leaf, {:.0f} leaves\n", threads,
             splits, 1e-6 * splits / seconds, static_cast<double>(elements.memory_bytes()) / leaves, leaves);
}

}  // namespace

int main() {
  measure(1);
  measure(std::thread::hardware_concurrency());
  return 0;
}
