// Which surface is visible where several overlap.
#include "repair/surface_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/support/derived_scene.h"
#include "tests/support/lattice_random.h"
#include "tests/support/repaired_checks.h"
#include "tests/support/scene_variants.h"

namespace rad::repair {
namespace {

using scene::dvec3;

constexpr double kTolerance = 1.0 / 64;

std::vector<dvec3> sheet(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

SurfaceOrder order_of(const scene::Scene& scene, const CoplanarOptions& options = {}) {
  std::string refusal;
  const geom::ToleranceRequest request{kTolerance, geom::ToleranceRequest::Measure::FileUnits};
  return SurfaceOrder(validate::build_context(scene, {}, request, refusal).value(), options);
}

std::vector<std::uint32_t> ranks_of(const scene::Scene& scene, const CoplanarOptions& options = {}) {
  return order_of(scene, options).ranks();
}

// A small sheet on a larger one that emits light, in two materials and objects.
scene::Scene note_on_screen(const std::string& note = "note") {
  tests::SceneSketch sketch;
  sketch.use("screen", "glow");
  sketch.face(sheet(0, 0, 8, 4));
  sketch.use(note, "white");
  sketch.face(sheet(1, 1, 2, 2));
  scene::Scene scene = sketch.take();
  std::ranges::find(scene.materials, "glow", &scene::Material::name)->emission = {5, 5, 5};
  return scene;
}

// The material of the one triangle over a place of the plane z = 0; nothing where there are none or several.
std::optional<std::string> visible_at(const Repaired& result, const scene::Scene& scene, double x, double y) {
  std::vector<std::string> names;
  for (const scene::ConformingFace& face : result.model.faces) {
    for (const auto& ids : result.model.triangles_of(face)) {
      const auto corner = [&](std::size_t k) { return result.model.lattice.position(result.model.points[ids[k % 3]]); };
      const auto left_of = [&](std::size_t k) {
        const dvec3 a = corner(k), b = corner(k + 1);
        return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) > 0;
      };
      if (left_of(0) && left_of(1) && left_of(2)) names.push_back(scene.materials[face.material].name);
    }
  }
  if (names.size() != 1) return std::nullopt;
  return names[0];
}

TEST(SurfaceOrder, ShowsThePaperOnTheDesk) {
  for (const bool paper_first : {false, true}) {
    tests::SceneSketch sketch;
    const auto desk = [&] { sketch.use("desk", "wood"), sketch.face(sheet(0, 0, 8, 4)); };
    const auto paper = [&] { sketch.use("paper", "white"), sketch.face(sheet(1, 1, 2, 2)); };
    if (paper_first) paper();
    desk();
    if (!paper_first) paper();
    const scene::Scene scene = sketch.take();
    const auto ranks = ranks_of(scene);
    EXPECT_LT(ranks[paper_first ? 0 : 1], ranks[paper_first ? 1 : 0]);
    const Repaired result = tests::repaired(scene, kTolerance);
    EXPECT_EQ(visible_at(result, scene, 1.4, 1.3), "white");
    EXPECT_EQ(visible_at(result, scene, 3.4, 1.3), "wood");
  }
}

// The area of the whole surface counts, not that of the face that overlaps.
TEST(SurfaceOrder, ComparesWholeSurfaces) {
  tests::SceneSketch sketch;
  sketch.use("carpet", "red");
  sketch.face(sheet(0, 0, 4, 4));
  sketch.use("floor", "grey");
  for (int i = 0; i < 6; ++i) sketch.face(sheet(2 * i - 4, -4, 2 * i - 2, 8));
  const auto ranks = ranks_of(sketch.take());
  for (std::size_t i = 1; i < ranks.size(); ++i) EXPECT_LT(ranks[0], ranks[i]);
}

TEST(SurfaceOrder, LetsAnEmitterWin) {
  tests::SceneSketch sketch;
  sketch.use("ceiling", "white");
  sketch.face(sheet(0, 0, 1, 1));
  sketch.use("panel", "lamp");
  sketch.face(sheet(-1, -1, 3, 3));
  scene::Scene scene = sketch.take();
  EXPECT_LT(ranks_of(scene)[0], ranks_of(scene)[1]);
  const auto lamp = std::ranges::find(scene.materials, "lamp", &scene::Material::name);
  lamp->emission = {5, 5, 5};
  EXPECT_GT(ranks_of(scene)[0], ranks_of(scene)[1]);
  const Repaired result = tests::repaired(scene, kTolerance);
  EXPECT_EQ(visible_at(result, scene, 0.4, 0.3), "lamp");
}

TEST(SurfaceOrder, BreaksTheTieOfTwinsByName) {
  std::vector<std::string> winners;
  for (const bool swapped : {false, true}) {
    tests::SceneSketch sketch;
    sketch.use("", swapped ? "blue" : "amber");
    sketch.face(sheet(0, 0, 4, 4));
    sketch.use("", swapped ? "amber" : "blue");
    sketch.face(sheet(0, 0, 4, 4));
    const scene::Scene scene = sketch.take();
    const Repaired result = tests::repaired(scene, kTolerance);
    winners.push_back(visible_at(result, scene, 1.4, 1.3).value_or("none"));
  }
  EXPECT_EQ(winners, (std::vector<std::string>{"amber", "amber"}));
}

TEST(SurfaceOrder, HalvesADoubledModel) {
  tests::SceneSketch once, twice;
  for (auto* sketch : {&once, &twice, &twice}) sketch->box({0, 0, 0}, {3, 2, 1});
  const scene::Scene single = once.take(), doubled = twice.take();
  EXPECT_EQ(tests::placed_triangles(tests::repaired(doubled, kTolerance).model, doubled),
            tests::placed_triangles(tests::repaired(single, kTolerance).model, single));
}

// Any number of layers: everywhere the smallest that is there is seen, as if painted on last.
TEST(SurfaceOrder, AgreesWithThePainter) {
  struct Layer {
    double x0, y0, x1, y1;
    std::string name;
    [[nodiscard]] double area() const { return (x1 - x0) * (y1 - y0); }
    [[nodiscard]] bool has(double x, double y) const { return x0 < x && x < x1 && y0 < y && y < y1; }
  };
  std::size_t stacked = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    tests::LatticeRandom random(seed);
    std::vector<Layer> layers;
    tests::SceneSketch sketch;
    for (int i = 0; i < 5; ++i) {
      const auto x = static_cast<double>(random.between(0, 6)), y = static_cast<double>(random.between(0, 6));
      layers.push_back({x, y, x + static_cast<double>(random.between(2, 9)),
                        y + static_cast<double>(random.between(2, 9)),
                        "layer" + std::to_string(random.between(0, 9)) + std::to_string(i)});
    }
    std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) {
      return a.area() != b.area() ? a.area() < b.area() : a.name < b.name;
    });
    std::mt19937 order(static_cast<std::uint32_t>(seed));
    for (const std::uint32_t i : tests::shuffled(layers.size(), order)) {
      sketch.use("", layers[i].name);
      sketch.face(sheet(layers[i].x0, layers[i].y0, layers[i].x1, layers[i].y1, i % 2 == 0 ? 0 : kTolerance / 2));
    }
    const scene::Scene scene = sketch.take();
    const Repaired result = tests::repaired(scene, kTolerance);
    for (double x = 0.37; x < 15; ++x) {
      for (double y = 0.41; y < 15; ++y) {
        const auto top = std::ranges::find_if(layers, [&](const Layer& layer) { return layer.has(x, y); });
        if (top == layers.end()) continue;
        ASSERT_EQ(visible_at(result, scene, x, y), top->name) << x << ' ' << y;
        stacked += std::ranges::count_if(layers, [&](const Layer& layer) { return layer.has(x, y); }) > 2 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(stacked, 500u);
}

TEST(SurfaceOrder, FollowsThePolicy) {
  const scene::Scene scene = note_on_screen();
  const auto note_wins = [&](const CoplanarOptions& options) {
    const auto ranks = ranks_of(scene, options);
    return ranks[1] < ranks[0];
  };
  EXPECT_FALSE(note_wins({}));
  EXPECT_TRUE(note_wins({.emitter_priority = false}));
  EXPECT_TRUE(note_wins({.policy = CoplanarPolicy::Area}));
  EXPECT_TRUE(note_wins({.policy = CoplanarPolicy::KeepLast}));
  EXPECT_FALSE(note_wins({.policy = CoplanarPolicy::KeepFirst}));
  EXPECT_TRUE(note_wins({.policy = CoplanarPolicy::Priority, .priority = {"not?"}}));
  EXPECT_TRUE(note_wins({.priority = {"whi*"}}));
  EXPECT_TRUE(note_wins({.priority = {"white", "screen"}}));
  EXPECT_FALSE(note_wins({.priority = {"screen", "white"}}));
}

TEST(SurfaceOrder, SaysWhatDecided) {
  const scene::Scene scene = note_on_screen();
  EXPECT_EQ(order_of(scene).decided_by(0, 1), OrderRule::Emitter);
  EXPECT_EQ(order_of(scene, {.emitter_priority = false}).decided_by(1, 0), OrderRule::Area);
  EXPECT_EQ(order_of(scene, {.priority = {"note"}}).decided_by(1, 0), OrderRule::Priority);
  EXPECT_EQ(order_of(scene, {.policy = CoplanarPolicy::KeepLast}).decided_by(1, 0), OrderRule::FileOrder);
}

TEST(SurfaceOrder, PutsDecalsBeforeAllButPatterns) {
  for (const std::string name : {"decal", "Decal.001", "wall_decal_3", "DECAL"}) {
    const auto ranks = ranks_of(note_on_screen(name));
    EXPECT_LT(ranks[1], ranks[0]) << name;
    EXPECT_GT(ranks_of(note_on_screen(name), {.priority = {"glow"}})[1], 0u) << name;
  }
  for (const std::string name : {"decalcified", "indecal", "de cal"}) {
    EXPECT_GT(ranks_of(note_on_screen(name))[1], ranks_of(note_on_screen(name))[0]) << name;
  }
}

// Two sheets that are equal but for noise go by their names, whichever is a little larger.
TEST(SurfaceOrder, TakesNearlyEqualSheetsForEqual) {
  for (const double noise : {-3e-4, 0.0, 3e-4}) {
    for (const double size : {1.0, 1.7, 2.3, 3.9}) {
      tests::SceneSketch sketch;
      sketch.use("", "beech");
      sketch.face(sheet(0, 0, size, 4));
      sketch.use("", "ash");
      sketch.face(sheet(0, 0, size, 4 * (1 + noise)));
      const SurfaceOrder order = order_of(sketch.take());
      EXPECT_LT(order.ranks()[1], order.ranks()[0]) << size << ' ' << noise;
      EXPECT_EQ(order.decided_by(1, 0), OrderRule::Content);
    }
  }
  tests::SceneSketch sketch;
  sketch.use("", "beech");
  sketch.face(sheet(0, 0, 1, 4));
  sketch.use("", "ash");
  sketch.face(sheet(0, 0, 1, 4 * 1.002));
  EXPECT_LT(ranks_of(sketch.take())[0], 1u);
}

// Surfaces count whole in every pass, and no order of the faces of a file shows.
TEST(SurfaceOrder, IsTheSameForAllPermutations) {
  std::vector<std::size_t> order{0, 1, 2, 3};
  std::vector<tests::PlacedTriangle> first;
  do {
    const std::array<std::vector<dvec3>, 4> sheets{sheet(0, 0, 8, 8), sheet(2, 2, 10, 6), sheet(4, 1, 6, 9),
                                                   sheet(4, 1, 6, 9)};
    const std::array<std::string, 4> names{"floor", "rug", "runner", "runner copy"};
    tests::SceneSketch sketch;
    for (const std::size_t i : order) {
      sketch.use(names[i], names[i]);
      sketch.face(sheets[i]);
    }
    const scene::Scene scene = sketch.take();
    const auto placed = tests::placed_triangles(tests::repaired(scene, kTolerance).model, scene);
    if (first.empty()) first = placed;
    EXPECT_EQ(placed, first);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(SurfaceOrder, KnowsItsPoliciesByName) {
  EXPECT_EQ(parse_coplanar_policy("keep-last"), CoplanarPolicy::KeepLast);
  EXPECT_EQ(parse_coplanar_policy("layer"), std::nullopt);
}

}  // namespace
}  // namespace rad::repair
