// Where all features are more than 10 T apart, repair must find the exact arrangement: the same vertices, the same
// cells in each face, the same faces along each other, the same areas.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <set>

#include "corpus/random.h"
#include "scene/disjoint_sets.h"
#include "scene/scene_builder.h"
#include "tests/support/exact_face_map.h"
#include "tests/support/repaired_checks.h"

namespace rad::repair {
namespace {

using geom::dvec3;
using geom::LatticePoint;
using scene::PointId;
using tests::ExactFace;
using tests::ExactFaceMap;

constexpr double kTolerance = 1.0 / 64;
// Coordinates are multiples of it: lattice points whatever the pitch.
constexpr double kStep = 1.0 / 4;
constexpr int kReach = 40;  // steps
constexpr double kApart = 10 * kTolerance / kStep;

using Outline = std::vector<LatticePoint>;

/// Boxes, sheets and triangles between whole points, each face an object of its own so that none are merged.
class WholeScene {
 public:
  explicit WholeScene(std::uint64_t seed) : random_(seed) {
    for (int parts = random_.between(2, 4); parts > 0; --parts) {
      switch (random_.between(0, 2)) {
        case 0:
          add_box();
          break;
        case 1:
          add_sheet();
          break;
        default:
          add_triangle();
      }
    }
  }

  [[nodiscard]] const std::vector<Outline>& faces() const { return faces_; }

  [[nodiscard]] scene::Scene scene() const {
    scene::SceneBuilder builder("scene.obj", "obj");
    builder.add_section({"scene.obj", "", scene::RecordKind::Line});
    for (const Outline& outline : faces_) {
      const std::size_t record = builder.scene().faces.size() + 1;
      builder.use_object(builder.object("face" + std::to_string(record)));
      std::vector<scene::VertexId> ids;
      for (const LatticePoint& p : outline) ids.push_back(builder.add_vertex(kStep * geom::as_vector(p)));
      builder.add_face(ids, record);
    }
    return builder.take();
  }

 private:
  LatticePoint point() {
    const int x = random_.between(-kReach, kReach), y = random_.between(-kReach, kReach);
    return {x, y, random_.between(-kReach, kReach)};
  }
  void add_box() {
    const LatticePoint a = point(), b = point();
    if (a.x == b.x || a.y == b.y || a.z == b.z) return;
    const auto [x0, x1] = std::minmax(a.x, b.x);
    const auto [y0, y1] = std::minmax(a.y, b.y);
    const auto [z0, z1] = std::minmax(a.z, b.z);
    faces_.push_back({{x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}, {x0, y1, z0}});
    faces_.push_back({{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}});
    faces_.push_back({{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}});
    faces_.push_back({{x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}, {x1, y1, z0}});
    faces_.push_back({{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}});
    faces_.push_back({{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}});
  }
  void add_sheet() {
    const LatticePoint a = point(), b = point(), c = point();
    const LatticePoint d{b.x + c.x - a.x, b.y + c.y - a.y, b.z + c.z - a.z};
    if (!geom::collinear(a, b, c)) faces_.push_back({a, b, d, c});
  }
  void add_triangle() {
    const LatticePoint a = point(), b = point(), c = point();
    if (!geom::collinear(a, b, c)) faces_.push_back({a, b, c});
  }

  corpus::Random random_;
  std::vector<Outline> faces_;
};

/// The exact answer for a scene, and whether it is one that repair can be held to.
class ExactScene {
 public:
  explicit ExactScene(const std::vector<Outline>& outlines) {
    for (const Outline& outline : outlines) faces_.emplace_back(outline);
    for (std::size_t i = 0; i < faces_.size(); ++i) maps_.emplace_back(faces_, i);
    for (const ExactFaceMap& map : maps_) {
      for (const dvec3& p : map.points()) {
        const auto same = [&](const dvec3& q) { return glm::distance(p, q) < 1e-6; };
        if (std::ranges::none_of(points_, same)) points_.push_back(p);
      }
    }
  }

  [[nodiscard]] const std::vector<ExactFaceMap>& maps() const { return maps_; }
  [[nodiscard]] const std::vector<dvec3>& points() const { return points_; }

  [[nodiscard]] double distance_to_edges(const dvec3& p) const {
    double least = INFINITY;
    for (const ExactFaceMap& map : maps_) {
      for (const auto& [from, to] : map.edges()) least = std::min(least, geom::distance_to_segment(p, from, to));
    }
    return least;
  }

  /// No two faces overlap, and every two features that do not meet are more than 10 T from each other.
  [[nodiscard]] bool is_clear_cut() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (glm::distance(points_[i], points_[j]) <= kApart) return false;
      }
    }
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      if (maps_[i].overlapping() || near_an_edge(maps_[i]) || near_the_inside(i)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool near_an_edge(const ExactFaceMap& map) const {
    for (const auto& [from, to] : map.edges()) {
      for (const dvec3& p : points_) {
        const double distance = geom::distance_to_segment(p, from, to);
        if (distance > 1e-6 && distance <= kApart) return true;
        if (distance <= 1e-6 && glm::distance(p, from) > 1e-6 && glm::distance(p, to) > 1e-6) return true;
      }
    }
    return false;
  }

  // Points over a face that are not points of its map.
  [[nodiscard]] bool near_the_inside(std::size_t face) const {
    std::vector<dvec3> corners;
    for (const auto& p : faces_[face].corners()) {
      corners.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    const auto own = maps_[face].points();
    for (const dvec3& p : points_) {
      const auto same = [&](const dvec3& q) { return glm::distance(p, q) < 1e-6; };
      if (std::ranges::any_of(own, same)) continue;
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        if (distance_to_triangle(p, std::array{corners[0], corners[i], corners[i + 1]}) <= kApart) return true;
      }
    }
    return false;
  }

  std::vector<ExactFace> faces_;
  std::vector<ExactFaceMap> maps_;
  std::vector<dvec3> points_;
};

/// What repair made of each face of the input.
class RepairedFaces {
 public:
  RepairedFaces(const scene::ConformingModel& model, std::size_t faces)
      : model_(model), triangles_(faces), neighbours_(faces) {
    for (const scene::ConformingFace& face : model.faces) {
      for (const auto& ids : model.triangles_of(face)) {
        triangles_[face.source].push_back(ids);
        for (std::size_t i = 0; i < 3; ++i) users_[edge(ids[i], ids[(i + 1) % 3])].insert(face.source);
      }
      for (const auto& [a, b] : model.inner_edges_of(face)) drawn_.insert(edge(a, b));
    }
    for (const auto& [key, sources] : users_) {
      for (const std::size_t a : sources) {
        for (const std::size_t b : sources) {
          if (a != b) neighbours_[a].insert(b);
        }
      }
    }
  }

  [[nodiscard]] std::vector<std::size_t> neighbours(std::size_t face) const {
    return {neighbours_[face].begin(), neighbours_[face].end()};
  }

  /// Sets of triangles that are joined by edges which nothing else touches.
  [[nodiscard]] std::size_t cells(std::size_t face) const {
    const auto& triangles = triangles_[face];
    std::map<std::pair<PointId, PointId>, std::size_t> first_at;
    scene::DisjointSets sets(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto key = edge(triangles[t][i], triangles[t][(i + 1) % 3]);
        if (users_.at(key).size() > 1 || drawn_.contains(key)) continue;
        const auto [entry, fresh] = first_at.try_emplace(key, t);
        if (!fresh) sets.unite(static_cast<std::uint32_t>(entry->second), static_cast<std::uint32_t>(t));
      }
    }
    std::set<std::uint32_t> roots;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) roots.insert(sets.find(t));
    return roots.size();
  }

  [[nodiscard]] double area(std::size_t face) const {
    double sum = 0;
    for (const auto& ids : triangles_[face]) {
      const dvec3 a = place(ids[0]), b = place(ids[1]), c = place(ids[2]);
      sum += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return sum;
  }

  /// Points that triangles use.
  [[nodiscard]] std::vector<dvec3> points() const {
    std::set<PointId> used;
    for (const auto& triangles : triangles_) {
      for (const auto& ids : triangles) used.insert(ids.begin(), ids.end());
    }
    std::vector<dvec3> all;
    for (const PointId id : used) all.push_back(place(id));
    return all;
  }

 private:
  static std::pair<PointId, PointId> edge(PointId a, PointId b) { return std::minmax(a, b); }
  // In steps.
  [[nodiscard]] dvec3 place(PointId id) const { return model_.lattice.position(model_.points[id]) / kStep; }

  const scene::ConformingModel& model_;
  std::vector<std::vector<std::array<PointId, 3>>> triangles_;
  std::vector<std::set<std::size_t>> neighbours_;
  std::map<std::pair<PointId, PointId>, std::set<std::size_t>> users_;
  std::set<std::pair<PointId, PointId>> drawn_;
};

double exact_area(const Outline& outline) {
  dvec3 sum(0, 0, 0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += glm::cross(geom::as_vector(outline[i]), geom::as_vector(outline[(i + 1) % outline.size()]));
  }
  return glm::length(sum) / 2;
}

double perimeter(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += glm::distance(geom::as_vector(outline[i]), geom::as_vector(outline[(i + 1) % outline.size()]));
  }
  return sum;
}

void expect_exact(const WholeScene& whole, const ExactScene& exact) {
  const Repaired result = tests::repaired(whole.scene(), kTolerance);
  ASSERT_EQ(result.unresolved, 0u);
  const double rounding = 2 * result.model.lattice.pitch / kStep;
  const RepairedFaces ours(result.model, whole.faces().size());
  for (std::size_t face = 0; face < whole.faces().size(); ++face) {
    SCOPED_TRACE("face " + std::to_string(face));
    EXPECT_EQ(ours.neighbours(face), exact.maps()[face].neighbours());
    EXPECT_EQ(ours.cells(face), exact.maps()[face].cells());
    EXPECT_NEAR(ours.area(face), exact_area(whole.faces()[face]), rounding * perimeter(whole.faces()[face]));
  }
  const std::vector<dvec3> points = ours.points();
  for (const dvec3& p : exact.points()) {
    const auto here = [&](const dvec3& q) { return glm::distance(p, q) <= rounding; };
    EXPECT_EQ(std::ranges::count_if(points, here), 1) << p.x << ' ' << p.y << ' ' << p.z;
  }
  std::size_t steiner = 0;
  for (const scene::LedgerEntry& entry : result.ledger) {
    if (entry.operation == "add-steiner-point") steiner += entry.count;
    EXPECT_LE(entry.largest_movement / kStep, rounding) << entry.operation;
  }
  // Repair may divide an edge of the arrangement once more than it must, but it draws nothing anywhere else.
  const auto off_all_edges = [&](const dvec3& p) { return exact.distance_to_edges(p) > rounding; };
  EXPECT_LE(static_cast<std::size_t>(std::ranges::count_if(points, off_all_edges)), steiner);
}

TEST(ExactArrangement, IsWhatRepairFindsWhereFeaturesAreApart) {
  constexpr int kSeeds = 150, kLeastCompared = 30;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const WholeScene whole(seed);
    if (whole.faces().empty()) continue;
    const ExactScene exact(whole.faces());
    if (!exact.is_clear_cut()) continue;
    ++compared;
    expect_exact(whole, exact);
  }
  EXPECT_GE(compared, kLeastCompared);
}

}  // namespace
}  // namespace rad::repair
