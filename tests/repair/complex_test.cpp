// The conforming complex against a slow one that keeps a set of items for each edge and derives all else.
#include "repair/complex.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/lattice_random.h"

namespace rad::repair {
namespace {

constexpr double kTolerance = 16;

const Plane kFloor({0, 0, 1}, {0, 0, 0});

template <typename Set>
auto sorted(const Set& set) {
  return std::set<typename Set::key_type>(set.begin(), set.end());
}

// What is in a complex, without any shortcut.
struct SlowComplex {
  std::map<EdgeKey, std::set<Item>> edges;
  std::map<ClusterId, std::set<PointId>> imprinted;

  void toggle(EdgeKey edge, Item item) {
    const auto [a, b] = ends_of(edge);
    if (a == b) return;
    std::set<Item>& items = edges[edge];
    if (!items.insert(item).second && item.is_piece()) items.erase(item);
    if (items.empty()) edges.erase(edge);
  }

  void split(EdgeKey edge, PointId at) {
    const auto [a, b] = ends_of(edge);
    if (at == a || at == b || !edges.contains(edge)) return;
    const std::set<Item> items = edges[edge];
    edges.erase(edge);
    for (const Item item : items) {
      toggle(edge_key(a, at), item);
      toggle(edge_key(at, b), item);
      if (!item.is_piece()) imprinted[item.imprinted_cluster()].insert({a, at, b});
    }
  }

  void merge(PointId from, PointId to) {
    const std::map<EdgeKey, std::set<Item>> before = std::move(edges);
    edges.clear();
    const auto renamed = [&](PointId id) { return id == from ? to : id; };
    for (const auto& [edge, items] : before) {
      const auto [a, b] = ends_of(edge);
      if (renamed(a) == renamed(b)) continue;
      for (const Item item : items) toggle(edge_key(renamed(a), renamed(b)), item);
    }
    for (auto& [cluster, points] : imprinted) {
      if (points.erase(from) > 0) points.insert(to);
    }
  }
};

class ComplexFixture {
 public:
  ComplexFixture(std::size_t points, ClusterId clusters, PieceId pieces) {
    for (std::size_t i = 0; i < points; ++i) complex.add_point({static_cast<std::int32_t>(1000 * i), 0, 0});
    for (ClusterId i = 0; i < clusters; ++i) complex.add_cluster(kFloor, 1);
    for (PieceId i = 0; i < pieces; ++i) complex.add_piece({i % clusters, true, i, i});
  }

  void toggle(PointId a, PointId b, Item item) {
    complex.toggle(edge_key(a, b), item);
    slow.toggle(edge_key(a, b), item);
  }

  [[nodiscard]] std::set<EdgeKey> edges_of(ClusterId cluster) const {
    std::set<EdgeKey> found;
    for (const auto& [edge, items] : slow.edges) {
      if (std::ranges::any_of(items, [&](Item item) { return complex.cluster_of(item) == cluster; }))
        found.insert(edge);
    }
    return found;
  }

  [[nodiscard]] bool agrees() const {
    std::vector<EdgeKey> expected;
    for (const auto& [edge, items] : slow.edges) {
      expected.push_back(edge);
      const auto own = complex.items(edge);
      if (own.size() != items.size() || std::set(own.begin(), own.end()) != items) return false;
    }
    return complex.edges() == expected && clusters_agree() && points_agree();
  }

  Complex complex{kTolerance};
  SlowComplex slow;

 private:
  [[nodiscard]] std::set<PointId> imprinted_in(ClusterId cluster) const {
    const auto found = slow.imprinted.find(cluster);
    return found == slow.imprinted.end() ? std::set<PointId>() : found->second;
  }

  [[nodiscard]] bool clusters_agree() const {
    for (ClusterId id = 0; id < complex.clusters().size(); ++id) {
      const Cluster& cluster = complex.clusters()[id];
      if (sorted(cluster.edges) != edges_of(id) || sorted(cluster.points) != imprinted_in(id)) return false;
    }
    return true;
  }

  [[nodiscard]] bool points_agree() const {
    for (PointId id = 0; id < complex.point_count(); ++id) {
      bool live = false;
      for (ClusterId cluster = 0; cluster < complex.clusters().size(); ++cluster) {
        const auto edges = edges_of(cluster);
        const bool in = imprinted_in(cluster).contains(id) || std::ranges::any_of(edges, [&](EdgeKey edge) {
                          return std::ranges::count(ends_of(edge), id) > 0;
                        });
        if (complex.in_cluster(id, cluster) != in) return false;
        live |= in;
      }
      if (complex.live(id) != live) return false;
    }
    return true;
  }
};

TEST(Complex, TogglesTwiceToNothing) {
  ComplexFixture fixture(2, 1, 1);
  fixture.complex.toggle(edge_key(0, 1), Item::piece(0));
  EXPECT_TRUE(fixture.complex.has_edge(edge_key(0, 1)));
  fixture.complex.toggle(edge_key(1, 0), Item::piece(0));
  EXPECT_FALSE(fixture.complex.has_edge(edge_key(0, 1)));
  EXPECT_FALSE(fixture.complex.live(0));
  EXPECT_TRUE(fixture.complex.clusters()[0].edges.empty());
}

TEST(Complex, KeepsAnImprintThatIsSetTwice) {
  ComplexFixture fixture(2, 1, 1);
  fixture.toggle(0, 1, Item::imprint(0));
  fixture.toggle(0, 1, Item::imprint(0));
  EXPECT_EQ(fixture.complex.items(edge_key(0, 1)).size(), 1u);
  EXPECT_TRUE(fixture.agrees());
}

TEST(Complex, TellsPiecesFromImprints) {
  for (const std::uint32_t id : {0u, 1u, 7u, 1u << 30}) {
    EXPECT_TRUE(Item::piece(id).is_piece());
    EXPECT_EQ(Item::piece(id).piece_id(), id);
    EXPECT_FALSE(Item::imprint(id).is_piece());
    EXPECT_EQ(Item::imprint(id).imprinted_cluster(), id);
  }
}

TEST(Complex, SplitsAnEdgeForAllItsPieces) {
  ComplexFixture fixture(3, 2, 2);
  for (const Item item : {Item::piece(0), Item::piece(1), Item::imprint(1)}) fixture.toggle(0, 1, item);
  EXPECT_TRUE(fixture.complex.split(edge_key(0, 1), 2));
  EXPECT_FALSE(fixture.complex.has_edge(edge_key(0, 1)));
  EXPECT_EQ(fixture.complex.items(edge_key(0, 2)).size(), 3u);
  EXPECT_EQ(fixture.complex.items(edge_key(2, 1)).size(), 3u);
  EXPECT_EQ(sorted(fixture.complex.clusters()[1].points), (std::set<PointId>{0, 1, 2}));
  EXPECT_FALSE(fixture.complex.split(edge_key(0, 1), 2));
  EXPECT_FALSE(fixture.complex.split(edge_key(0, 2), 2));
}

// An edge that a piece runs along there and back is no edge of it.
TEST(Complex, LosesAnAntenna) {
  ComplexFixture fixture(4, 1, 1);
  for (const auto& [a, b] : {std::pair(0u, 1u), {1u, 2u}, {2u, 0u}, {2u, 3u}}) fixture.toggle(a, b, Item::piece(0));
  fixture.complex.merge(3, 0);
  EXPECT_FALSE(fixture.complex.has_edge(edge_key(0, 2)));
  EXPECT_FALSE(fixture.complex.live(3));
  EXPECT_EQ(fixture.complex.edges(), (std::vector{edge_key(0, 1), edge_key(1, 2)}));
}

TEST(Complex, ClosesATriangleThatIsMergedToAnEdge) {
  ComplexFixture fixture(3, 1, 1);
  for (const auto& [a, b] : {std::pair(0u, 1u), {1u, 2u}, {2u, 0u}}) fixture.toggle(a, b, Item::piece(0));
  fixture.complex.merge_either(2, 1);
  EXPECT_TRUE(fixture.complex.edges().empty());
  EXPECT_EQ(fixture.complex.counts().merges, 1u);
  EXPECT_EQ(fixture.complex.counts().largest_merge, 1000);
}

TEST(Complex, SplitsOnlyWhatGetsShorter) {
  Complex complex(kTolerance);
  const PointId a = complex.add_point({0, 0, 0}), b = complex.add_point({1000, 0, 0});
  EXPECT_TRUE(complex.split_shortens(edge_key(a, b), complex.add_point({500, 10, 0})));
  EXPECT_TRUE(complex.split_shortens(edge_key(a, b), complex.add_point({1, 40, 0})));
  EXPECT_FALSE(complex.split_shortens(edge_key(a, b), complex.add_point({0, 40, 0})));
  EXPECT_FALSE(complex.split_shortens(edge_key(a, b), complex.add_point({-20, 0, 0})));
}

TEST(Complex, UsesTheNearestPointWithinReach) {
  ComplexFixture fixture(3, 1, 1);
  fixture.toggle(0, 1, Item::piece(0));
  Complex& complex = fixture.complex;
  complex.refresh_search();
  EXPECT_EQ(complex.point_at({995, 3, 0}, 10), 1u);
  EXPECT_EQ(complex.point_at({1995, 0, 0}, 10), 3u) << "point 2 is not live";
  EXPECT_EQ(complex.point_at({1996, 0, 0}, 10), 3u) << "new points are found again";
  EXPECT_EQ(complex.point(complex.point_at({500.4, 0.6, -7.5}, 10)), (LatticePoint{500, 1, -8}));
  EXPECT_EQ(complex.counts().new_points, 2u);
}

TEST(Complex, GrowsTheVersionOfWhatChanges) {
  ComplexFixture fixture(3, 2, 2);
  const auto versions = [&] {
    return std::array{fixture.complex.clusters()[0].version, fixture.complex.clusters()[1].version};
  };
  auto before = versions();
  const auto expect_grown = [&](std::size_t which) {
    EXPECT_GT(versions()[which], before[which]);
    EXPECT_EQ(versions()[1 - which], before[1 - which]);
    before = versions();
  };
  fixture.complex.toggle(edge_key(0, 1), Item::piece(1));
  expect_grown(1);
  fixture.complex.split(edge_key(0, 1), 2);
  expect_grown(1);
  EXPECT_TRUE(fixture.complex.imprint_point(0, 2));
  expect_grown(0);
  EXPECT_FALSE(fixture.complex.imprint_point(0, 2));
  EXPECT_EQ(versions(), before);
  fixture.complex.drop_point(0, 2);
  expect_grown(0);
  fixture.complex.merge(2, 0);
  expect_grown(1);
}

RC_GTEST_PROP(ComplexProperty, AgreesWithTheSlowOne, (std::uint64_t seed)) {
  tests::LatticeRandom random(seed);
  ComplexFixture fixture(8, 3, 5);
  const auto id = [&](std::int64_t count) { return static_cast<std::uint32_t>(random.between(0, count - 1)); };
  for (int step = 0; step < 60; ++step) {
    const PointId a = id(8), b = id(8), c = id(8);
    const ClusterId cluster = id(3);
    switch (random.between(0, 7)) {
      case 0:
        fixture.complex.merge(a, b);
        if (a != b) fixture.slow.merge(a, b);
        break;
      case 1:
        fixture.toggle(a, b, Item::imprint(cluster));
        break;
      case 2:
        fixture.complex.imprint_point(cluster, a);
        fixture.slow.imprinted[cluster].insert(a);
        break;
      case 3:
        fixture.complex.drop_point(cluster, a);
        fixture.slow.imprinted[cluster].erase(a);
        break;
      case 4:
        if (a == b) break;
        fixture.complex.split(edge_key(a, b), c);
        fixture.slow.split(edge_key(a, b), c);
        break;
      default:
        fixture.toggle(a, b, Item::piece(id(5)));
    }
    RC_ASSERT(fixture.agrees());
  }
}

}  // namespace
}  // namespace rad::repair
