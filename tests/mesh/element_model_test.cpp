// The element library against a reference that shares no idea with it, over many random refinements.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "tests/mesh/hand_made_patches.h"
#include "tests/mesh/reference_elements.h"

namespace rad::tests {
namespace {

using mesh::ElementId;
using mesh::ElementMesh;

ReferenceElements::Ring ring_of(const ElementMesh& elements, ElementId element) {
  ReferenceElements::Ring ring;
  for (const auto corners = elements.corners(element); const mesh::NodeId node : corners.all()) {
    ring.push_back(ReferenceElements::place(elements.points()[elements.point_of(node)]));
  }
  return ring;
}

std::set<ReferenceElements::Ring> leaves_of(const ElementMesh& elements) {
  std::set<ReferenceElements::Ring> rings;
  for (const ElementId leaf : elements.leaves()) {
    rings.insert(ReferenceElements::from_least(ring_of(elements, leaf)));
  }
  return rings;
}

// Every operation names one random element of a level below `deepest`, leaf or not.
void compare(std::size_t operations, std::uint32_t patches, std::uint64_t seed) {
  constexpr std::uint32_t kDeepest = 6;  // the library leaves what is narrower than 4 spacings; the reference does not
  ElementMesh elements(sheet_of_patches(patches, 1 << 12, seed));
  ReferenceElements reference;
  for (ElementId patch = 0; patch < elements.patch_count(); ++patch) reference.add(ring_of(elements, patch));
  LatticeRandom random(seed);
  for (std::size_t i = 0; i < operations; ++i) {
    const auto chosen =
        static_cast<ElementId>(random.between(0, static_cast<std::int64_t>(elements.element_count()) - 1));
    if (!elements.is_leaf(chosen) || elements.level(chosen) >= kDeepest) continue;
    reference.refine(ring_of(elements, chosen));
    elements.refine(std::array{chosen});
  }
  EXPECT_TRUE(leaves_of(elements) == reference.leaves()) << "seed " << seed;
  EXPECT_LE(static_cast<double>(elements.memory_bytes()), 100.0 * static_cast<double>(elements.leaves().size()));
}

TEST(ElementModel, RefinesAsTheReferenceDoes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) compare(2000, 3, seed);
}

TEST(ElementModel, RefinesAsTheReferenceDoesAMillionTimes) { compare(1'000'000, 20, 77); }

TEST(ElementModel, GivesTheSameIdsWithAnyNumberOfThreads) {
  const auto run = [](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    ElementMesh elements(sheet_of_patches(40, 1 << 12, 5));
    LatticeRandom random(9);
    std::vector<std::uint32_t> ids;
    for (int round = 0; round < 4; ++round) {
      std::vector<ElementId> chosen;
      for (const ElementId leaf : elements.leaves()) {
        if (random.one_in(round == 3 ? 8 : 2)) chosen.push_back(leaf);
      }
      ids.push_back(elements.refine(chosen).last);
    }
    for (const ElementId leaf : elements.leaves()) {
      ids.push_back(leaf);
      for (const auto corners = elements.corners(leaf); const mesh::NodeId node : corners.all()) {
        ids.push_back(node);
        ids.push_back(elements.point_of(node));
      }
    }
    return ids;
  };
  EXPECT_TRUE(run(1) == run(2));
}

TEST(ElementModel, NodesLieAtDistinctPointsOfASurface) {
  ElementMesh elements(sheet_of_patches(6, 1 << 12, 3));
  LatticeRandom random(4);
  for (int round = 0; round < 5; ++round) {
    std::vector<ElementId> chosen;
    for (const ElementId leaf : elements.leaves()) {
      if (random.one_in(5)) chosen.push_back(leaf);
    }
    elements.refine(chosen);
  }
  std::set<ReferenceElements::Place> places;
  for (mesh::NodeId node = 0; node < elements.node_count(); ++node) {
    EXPECT_TRUE(places.insert(ReferenceElements::place(elements.points()[elements.point_of(node)])).second);
  }
}

}  // namespace
}  // namespace rad::tests
