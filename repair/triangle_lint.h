// The lint of what will be written: the triangles, diagonals included. Repair ends when it is empty.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geom/box_tree.h"
#include "geom/growing_box_tree.h"
#include "geom/triangle_column.h"
#include "repair/triangulation.h"

namespace rad::repair {

/// In the order in which the residual loop cures them.
enum class ViolationKind : std::uint8_t {
  Intersection,  ///< two triangles meet elsewhere than in common corners and edges: exact
  NearCoplanar,  ///< the middle of one is within T of the inside of another that faces the same way
  PointOnEdge,   ///< a point is within T of the inside of an edge, or all of a triangle is within T of its longest
  Contact,       ///< two triangles come within T of each other where they have no common point
};

struct Violation {
  ViolationKind kind = ViolationKind::Intersection;
  std::uint32_t a = 0;  ///< triangle; of a PointOnEdge the one that has the edge
  std::uint32_t b = 0;  ///< triangle; of a PointOnEdge the edge: from corner b to corner b+1
  PointId point = 0;    ///< of a PointOnEdge

  friend constexpr auto operator<=>(const Violation&, const Violation&) = default;
};

/// What is linted.
struct TriangleSet {
  std::span<const LatticePoint> points;
  std::span<const Triangle> triangles;
  std::span<const std::uint8_t> alive;   ///< per triangle: it counts; empty where all do
  std::span<const std::uint8_t> folded;  ///< per cluster: its plane map folds over itself; empty where none does

  [[nodiscard]] bool is_alive(std::uint32_t triangle) const { return alive.empty() || alive[triangle] != 0; }
};

/// A violation and the two triangles that show it: it stands as long as both are alive.
struct Evidence {
  Violation violation;
  std::uint32_t other = 0;  ///< the second triangle; the first is violation.a

  friend constexpr auto operator<=>(const Evidence&, const Evidence&) = default;
};

using TrianglePair = std::array<std::uint32_t, 2>;

/// The violations of a set of triangles that changes: each update looks only at pairs of which one is new.
///
/// Legal: two triangles that lie on each other within T and look opposite ways (a box on a floor). Points near edges
/// are not legal even there: the display must be ziplocked.
class TriangleLint {
 public:
  /// `tolerance` is T in pitches.
  explicit TriangleLint(std::int64_t tolerance) : tolerance_(tolerance) {}

  /// `fresh`: the triangles that came alive since the last update, or must be looked at anew, each once. Points and
  /// triangles keep their ids and places for good.
  void update(const TriangleSet& set, std::span<const std::uint32_t> fresh);
  /// The same and update_contacts() in one go, where there is nothing from before.
  void start(const TriangleSet& set, std::span<const std::uint32_t> fresh);
  /// Takes in triangles between which nothing is wrong that it has to find: it is known already.
  void trust(const TriangleSet& set, std::span<const std::uint32_t> fresh);
  /// What lint of a written model would find at T between alive triangles beyond the exact violations: crossings and
  /// edges in faces as Contact, overlaps of the same facing as NearCoplanar. It is the search of lint itself
  /// (validate/contacts.h), with every triangle as a face.
  void update_contacts(const TriangleSet& set);

  /// All violations of update(), ascending.
  [[nodiscard]] std::vector<Violation> violations(const TriangleSet& set) const;
  /// All violations of update_contacts(), ascending.
  [[nodiscard]] std::vector<Violation> contacts() const;
  /// Calls visit(evidence) for all that both found, in no particular order.
  /// Pairs that start() found on each other within T, looking opposite ways, without being one triangle: legal, but
  /// meshes of both would not fit each other.
  [[nodiscard]] const std::vector<TrianglePair>& opposite_overlaps() const { return opposite_overlaps_; }
  template <typename Visit>
  void for_each_evidence(Visit&& visit) const {
    for (const Evidence& evidence : found_) visit(evidence);
    for (const Evidence& evidence : contacts_) visit(evidence);
  }

 private:
  friend class PairJudge;

  void add_triangles(const TriangleSet& set, std::span<const std::uint32_t> fresh);
  [[nodiscard]] std::vector<geom::LatticeBox> boxes_of(std::span<const std::uint32_t> triangles) const;
  /// Judges every pair of alive triangles near each other of which one is fresh, once. `own`: the tree of the boxes of
  /// the fresh ones.
  template <typename Judge>
  void for_each_pair(const TriangleSet& set, std::span<const std::uint32_t> fresh, const geom::BoxTree& own,
                     const Judge& judge) const;
  void put_into_tree(const TriangleSet& set, std::span<const std::uint32_t> fresh, geom::BoxTree own);

  std::int64_t tolerance_;
  std::vector<geom::LatticeBox> boxes_;  ///< per triangle, inflated so that boxes meet where triangles come within T
  std::vector<geom::TriangleColumn> columns_;  ///< per triangle
  geom::GrowingBoxTree tree_;
  std::vector<std::uint8_t> in_tree_;        ///< per triangle
  std::vector<TrianglePair> not_contacted_;  ///< near each other and not looked at by update_contacts yet
  std::vector<Evidence> found_;
  std::vector<Evidence> contacts_;
  std::vector<TrianglePair> opposite_overlaps_;
};

/// Whether there are neither violations nor contacts among triangles that do not change. `tolerance` is T in pitches.
bool has_no_fault(const TriangleSet& set, std::int64_t tolerance);

}  // namespace rad::repair
