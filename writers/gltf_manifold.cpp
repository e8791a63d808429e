#include "writers/gltf_manifold.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rad::writers::gltf {

namespace {

// Mixes an edge into a number that tells both its directions apart (SplitMix64).
std::uint64_t mixed(std::uint32_t from, std::uint32_t to) {
  std::uint64_t z = (std::uint64_t{from} << 32U | to) + 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

}  // namespace

bool is_closed_manifold(std::span<const std::uint32_t> corners) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  const auto edge = [&](std::size_t i) { return Edge(corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]); };
  // Where every edge has its opposite these sums are equal; an open surface is told without sorting.
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [from, to] = edge(i);
    sum += mixed(from, to) - mixed(to, from);
  }
  if (sum != 0) return false;
  std::vector<Edge> edges, opposite;
  edges.reserve(corners.size());
  opposite.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [from, to] = edge(i);
    if (from == to) return false;
    edges.emplace_back(from, to);
    opposite.emplace_back(to, from);
  }
  std::ranges::sort(edges);
  std::ranges::sort(opposite);
  return !edges.empty() && edges == opposite && std::ranges::adjacent_find(edges) == edges.end();
}

}  // namespace rad::writers::gltf
