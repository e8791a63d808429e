// Adaptive refinement of patches made by hand: a plate that shines on a floor close below, past a screen.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numeric>

#include "mesh/element_views.h"
#include "solve/form_factor.h"
#include "solve/solver.h"
#include "solve/strata.h"
#include "tests/support/grid_mesh.h"

namespace rad::solve {
namespace {

using tests::material;

constexpr std::int32_t kUnit = 1024;  ///< pitches

class Sheets {
 public:
  Sheets() {
    patches_.lattice.pitch = 1.0 / kUnit;
    patches_.tolerance.pitches = 1;
    patches_.tolerance.length = 1.0 / kUnit;
  }

  /// A rectangle of n × n patches; `u` × `v` shows to its front; all in units that are whole pitches.
  void add(const dvec3& origin, const dvec3& u, const dvec3& v, std::uint32_t n, scene::MaterialId material) {
    const auto first = static_cast<std::uint32_t>(patches_.points.size());
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const dvec3 place = origin + u * (double(i) / n) + v * (double(j) / n);
        patches_.node_point.push_back(static_cast<std::uint32_t>(patches_.points.size()));
        patches_.points.push_back(patches_.lattice.nearest(place));
      }
    }
    mesh::PatchSource source;
    source.face = faces_++;
    source.normal = glm::normalize(glm::cross(u, v));
    source.face_area = glm::length(glm::cross(u, v));
    source.material = material;
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + j * (n + 1) + i;
        patches_.corners.push_back({{a, a + 1, a + n + 2, a + n + 1}, 4});
        patches_.sources.push_back(source);
      }
    }
  }

  [[nodiscard]] mesh::ElementMesh elements() const { return mesh::ElementMesh(patches_); }

 private:
  mesh::ElementPatches patches_;
  std::uint32_t faces_ = 0;
};

constexpr double kHeight = 1.0 / 16;
const std::vector<scene::Material> kLightAndGrey{material(dvec3(0), dvec3(1, 2, 4)), material(dvec3(0.5)),
                                                 material(dvec3(0.3))};

Sheets light_over_floor() {
  Sheets sheets;
  sheets.add({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 8, 1);
  sheets.add({0.5, 0.5, kHeight}, {0, 1, 0}, {1, 0, 0}, 2, 0);
  return sheets;
}

Sheets light_past_a_screen() {
  Sheets sheets = light_over_floor();
  sheets.add({1.75, 0.25, kHeight / 2}, {0, 1.5, 0}, {0, 0, 0.5}, 2, 2);
  sheets.add({1.875, 0.25, 0.5}, {0, 0, -0.5}, {0, 1.5, 0}, 2, 2);
  return sheets;
}

mesh::RadiosityField refined(mesh::ElementMesh& elements, const RefineOptions& refine) {
  Progress progress;
  return solve(elements, kLightAndGrey, {}, refine, progress);
}

/// The largest difference, over the centres of the floor's leaves, of what is interpolated there from the exact
/// radiosity under the free light, as a share of the largest radiosity.
double worst_error(const mesh::ElementMesh& elements, const mesh::RadiosityField& field) {
  const std::array<dvec3, 4> light{dvec3{0.5, 0.5, kHeight}, dvec3{0.5, 1.5, kHeight}, dvec3{1.5, 1.5, kHeight},
                                   dvec3{1.5, 0.5, kHeight}};
  const mesh::RadiosityMesh mesh = mesh::radiosity_mesh(elements);
  double worst = 0;
  for (const mesh::Element& element : mesh.elements) {
    if (mesh.patches[element.patch].material != 1) continue;
    dvec3 centre(0);
    double mean = 0;
    for (const mesh::NodeId node : element.corners.all()) {
      centre += mesh.nodes[node].position / double(element.corners.count);
      mean += field.radiosity[node].x / element.corners.count;
    }
    const Receiver receiver{centre, {0, 0, 1}};
    worst = std::max(worst, std::abs(mean - 0.5 * form_factor(above_horizon(light, receiver), receiver.normal)) / 0.5);
  }
  return worst;
}

TEST(Refinement, FollowsTheLightOfANearPlate) {
  mesh::ElementMesh coarse = light_over_floor().elements(), fine = coarse, finer = coarse;
  RefineOptions options;
  options.levels = 0;
  const double before = worst_error(coarse, refined(coarse, options));
  options.levels = 2;
  const double after_two = worst_error(fine, refined(fine, options));
  options.levels = 5;
  const double after_five = worst_error(finer, refined(finer, options));
  EXPECT_GT(before, 0.1);
  EXPECT_LT(after_two, 0.6 * before);
  EXPECT_LT(after_five, 0.02);
  // What lies far from the light's edge stays as it was.
  const std::size_t divided_everywhere = 64 * 1024;
  EXPECT_LT(finer.leaves().size(), divided_everywhere / 4);
}

TEST(Refinement, ReplayEqualsRestart) {
  mesh::ElementMesh elements = light_past_a_screen().elements();
  RefineOptions options;
  options.levels = 3;
  const mesh::RadiosityField replayed = refined(elements, options);
  Progress progress;
  const mesh::RadiosityMesh mesh = mesh::radiosity_mesh(elements);
  ASSERT_EQ(replayed.radiosity.size(), mesh.nodes.size());
  const mesh::RadiosityField restarted = solve(mesh, kLightAndGrey, {}, progress);
  double sum = 0, difference = 0;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    sum += restarted.radiosity[node].x;
    difference += std::abs(restarted.radiosity[node].x - replayed.radiosity[node].x);
  }
  EXPECT_LT(difference, 0.005 * sum);
}

TEST(Refinement, GivesTheSameBitsWithAnyNumberOfThreads) {
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    mesh::ElementMesh elements = light_past_a_screen().elements();
    return refined(elements, {}).radiosity;
  };
  const std::vector<dvec3> one = with_threads(1), two = with_threads(2);
  ASSERT_EQ(one.size(), two.size());
  EXPECT_GT(one.size(), light_past_a_screen().elements().node_count());
  EXPECT_EQ(std::memcmp(one.data(), two.data(), one.size() * sizeof(dvec3)), 0);
}

TEST(Refinement, KeepsToTheNumberOfElements) {
  const std::size_t before = light_over_floor().elements().leaves().size();
  RefineOptions options;
  std::size_t last = before;
  for (const std::size_t most : {before + 60, before + 300, before + 1500}) {
    mesh::ElementMesh elements = light_over_floor().elements();
    options.most_elements = most;
    refined(elements, options);
    // Balance divides neighbours as well.
    EXPECT_LT(elements.leaves().size(), before + 2 * (most - before));
    EXPECT_GT(elements.leaves().size(), last);
    last = elements.leaves().size();
  }
}

TEST(Refinement, LeavesEdgesAsLongAsAskedFor) {
  mesh::ElementMesh elements = light_over_floor().elements();
  RefineOptions options;
  options.levels = 8;
  options.shortest_edge = 0.0625;  // the floor's patches are 0.25 long
  refined(elements, options);
  std::uint32_t deepest = 0;
  for (const mesh::ElementId leaf : elements.leaves()) deepest = std::max(deepest, elements.level(leaf));
  EXPECT_EQ(deepest, 2u);
}

TEST(Refinement, WhereTheMeshIsAtFaultItStaysAsItWas) {
  mesh::ElementMesh elements = light_over_floor().elements(), plain = elements;
  RefineOptions options;
  std::size_t judged = 0;
  options.at_fault = [&](const mesh::ElementMesh& mesh) {
    ++judged;
    std::vector<mesh::PatchId> patches;
    for (const mesh::ElementId leaf : mesh.leaves()) {
      if (mesh.level(leaf) > 0) patches.push_back(mesh.patch_of(leaf));
    }
    return patches;
  };
  const mesh::RadiosityField field = refined(elements, options);
  options.levels = 0;
  EXPECT_GE(judged, 2u);
  EXPECT_EQ(elements.leaves(), plain.leaves());
  EXPECT_EQ(field.radiosity.size(), plain.node_count());
}

TEST(Refinement, AStoppedSolveIsNotRefined) {
  mesh::ElementMesh elements = light_over_floor().elements();
  Progress progress([](const ProgressState&) { return false; });
  const mesh::RadiosityField field = solve(elements, kLightAndGrey, {}, RefineOptions{}, progress);
  EXPECT_FALSE(field.complete);
  EXPECT_EQ(elements.leaves().size(), light_over_floor().elements().leaves().size());
}

}  // namespace
}  // namespace rad::solve
