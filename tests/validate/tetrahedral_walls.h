// Complexes of tetrahedra with random walls, of which the air cells are known beforehand.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include "geom/predicates.h"
#include "scene/disjoint_sets.h"
#include "scene/lattice_model.h"
#include "tests/support/lattice_random.h"

namespace rad::tests {

using geom::Int128;
using geom::LatticePoint;
using scene::PointId;
using Corners = std::array<PointId, 3>;

struct Walls {
  std::vector<LatticePoint> points;
  std::vector<Corners> triangles;

  PointId add(std::int64_t x, std::int64_t y, std::int64_t z) {
    points.push_back({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)});
    return static_cast<PointId>(points.size() - 1);
  }

  void add_quad(PointId a, PointId b, PointId c, PointId d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }

  void add_box(std::int64_t low, std::int64_t high, std::int64_t shift = 0) {
    std::array<PointId, 8> v{};
    for (unsigned i = 0; i < 8; ++i) v[i] = add((i & 1 ? high : low) + shift, i & 2 ? high : low, i & 4 ? high : low);
    constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& s : kSides) add_quad(v[s[0]], v[s[1]], v[s[2]], v[s[3]]);
  }
};

/// Cubes of six tetrahedra each around a diagonal, corners shaken; every triangle between them is a wall or not.
class TetrahedralWalls {
 public:
  TetrahedralWalls(std::uint64_t seed, double share_of_walls) : random_(seed) {
    add_points();
    add_tetrahedra();
    choose_walls(share_of_walls);
    flood();
  }

  Walls walls;
  std::vector<std::array<std::uint32_t, 2>> expected;  ///< per wall: region in front of it and behind it
  std::map<std::uint32_t, Int128> volume6;             ///< per region

  /// The region around everything.
  [[nodiscard]] std::uint32_t outside() { return regions_->find(static_cast<std::uint32_t>(tetrahedra_.size())); }

 private:
  static constexpr int kCubes = 3, kStep = 64, kShake = 9;

  static PointId id(int x, int y, int z) { return static_cast<PointId>((x * (kCubes + 1) + y) * (kCubes + 1) + z); }

  void add_points() {
    for (int x = 0; x <= kCubes; ++x) {
      for (int y = 0; y <= kCubes; ++y) {
        for (int z = 0; z <= kCubes; ++z) {
          const auto shaken = [&](int at) { return at * kStep + random_.between(-kShake, kShake); };
          const std::int64_t px = shaken(x), py = shaken(y);
          walls.add(px, py, shaken(z));
        }
      }
    }
  }

  void add_tetrahedra() {
    for (int cube = 0; cube < kCubes * kCubes * kCubes; ++cube) {
      std::array<int, 3> axes{0, 1, 2};
      do {
        std::array<int, 3> at{cube / (kCubes * kCubes), cube / kCubes % kCubes, cube % kCubes};
        std::array<PointId, 4> corners{id(at[0], at[1], at[2])};
        for (std::size_t i = 0; i < 3; ++i) {
          ++at[static_cast<std::size_t>(axes[i])];
          corners[i + 1] = id(at[0], at[1], at[2]);
        }
        add_tetrahedron(corners);
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
  }

  void add_tetrahedron(std::array<PointId, 4> c) {
    const auto& p = walls.points;
    if (geom::orient3d(p[c[0]], p[c[1]], p[c[2]], p[c[3]]) == geom::Sign::Negative) std::swap(c[2], c[3]);
    ASSERT_EQ(geom::orient3d(p[c[0]], p[c[1]], p[c[2]], p[c[3]]), geom::Sign::Positive);
    const auto number = static_cast<std::uint32_t>(tetrahedra_.size());
    tetrahedra_.push_back(c);
    for (Corners face :
         {Corners{c[0], c[1], c[2]}, Corners{c[0], c[1], c[3]}, Corners{c[0], c[2], c[3]}, Corners{c[1], c[2], c[3]}}) {
      std::sort(face.begin(), face.end());
      beside_[face].push_back(number);
    }
  }

  void choose_walls(double share) {
    for (const auto& [face, tetrahedra] : beside_) {
      if (random_.unit() >= share) continue;
      Corners turned = face;
      if (random_.one_in(2)) std::swap(turned[1], turned[2]);
      std::rotate(turned.begin(), turned.begin() + random_.between(0, 2), turned.end());
      walls.triangles.push_back(turned);
      is_wall_.insert(face);
    }
  }

  // Regions: tetrahedra, and last what is around them, joined where there is no wall.
  void flood() {
    const auto outside = static_cast<std::uint32_t>(tetrahedra_.size());
    regions_.emplace(tetrahedra_.size() + 1);
    for (const auto& [face, tetrahedra] : beside_) {
      if (!is_wall_.contains(face)) regions_->unite(tetrahedra[0], tetrahedra.size() > 1 ? tetrahedra[1] : outside);
    }
    for (const Corners& wall : walls.triangles) {
      Corners face = wall;
      std::sort(face.begin(), face.end());
      std::array<std::uint32_t, 2> sides{outside, outside};
      for (const std::uint32_t t : beside_[face]) sides[in_front(wall, t) ? 0 : 1] = t;
      expected.push_back({regions_->find(sides[0]), regions_->find(sides[1])});
    }
    for (std::uint32_t t = 0; t < outside; ++t) {
      const auto& c = tetrahedra_[t];
      const auto& p = walls.points;
      volume6[regions_->find(t)] +=
          geom::dot(geom::cross(geom::difference(p[c[1]], p[c[0]]), geom::difference(p[c[2]], p[c[0]])),
                    geom::difference(p[c[3]], p[c[0]]));
    }
  }

  [[nodiscard]] bool in_front(const Corners& wall, std::uint32_t tetrahedron) const {
    for (const PointId corner : tetrahedra_[tetrahedron]) {
      if (std::ranges::find(wall, corner) != wall.end()) continue;
      const auto& p = walls.points;
      return geom::orient3d(p[wall[0]], p[wall[1]], p[wall[2]], p[corner]) == geom::Sign::Positive;
    }
    return false;
  }

  LatticeRandom random_;
  std::vector<std::array<PointId, 4>> tetrahedra_;
  std::map<Corners, std::vector<std::uint32_t>> beside_;
  std::set<Corners> is_wall_;
  std::optional<scene::DisjointSets> regions_;
};

}  // namespace rad::tests
