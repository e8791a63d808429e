// A Delaunay triangulation that takes points first and edges that must be kept afterwards. All on integers, exact.
//
// Points go in one by one: the triangles whose circles hold the new point make way for a star around it (Bowyer and
// Watson). Outside of the hull there are triangles too, with a corner at infinity, so that there is no border to
// treat apart. An edge that must be kept takes out the triangles that it runs through; both sides are filled with the
// triangles whose circles hold no other corner of theirs (Anglada).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/planar_mesh.h"

namespace rad::geom {

/// What became of an edge that was to be kept.
enum class KeptEdge : std::uint8_t {
  Whole,
  Split,    ///< points lie on it: it is kept in parts
  Crossed,  ///< it crosses one that was kept before; parts up to a point on it may have been kept
};

class PlanarDelaunay {
 public:
  /// Coordinates below 2^25 in magnitude.
  explicit PlanarDelaunay(std::span<const PlanarPoint> points)
      : points_(points), infinite_(static_cast<std::uint32_t>(points.size())) {}

  /// Inserts points, no two at one place. Once. False where all lie on a line: then there is no triangulation.
  bool insert(std::vector<std::uint32_t> order);
  /// Keeps the edge between two of the points.
  KeptEdge keep(std::uint32_t from, std::uint32_t to);
  /// The triangles of the hull.
  [[nodiscard]] std::vector<PlanarTriangle> triangles() const;

 private:
  struct Rim {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t outer = 0;
  };
  /// A side of a triangle by the two points that it joins.
  struct Link {
    std::uint64_t ends = 0;
    std::uint32_t triangle = 0;
    std::uint32_t side = 0;
  };
  /// Where the way from a point starts: along a side of a triangle, or through the one opposite.
  struct Start {
    std::uint32_t triangle = 0;
    std::uint32_t side = 0;
    bool along = false;
  };

  [[nodiscard]] Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orient2d(points_[a], points_[b], points_[c]);
  }
  [[nodiscard]] bool in_circle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  [[nodiscard]] bool in_conflict(const PlanarTriangle& triangle, std::uint32_t point) const;
  [[nodiscard]] bool is_finite(const PlanarTriangle& triangle) const;
  bool make_first(std::vector<std::uint32_t>& order);
  void insert(std::uint32_t point);
  [[nodiscard]] std::uint32_t find(std::uint32_t point) const;
  void dig(std::uint32_t first, std::uint32_t point);
  void fill_star(std::uint32_t point);
  [[nodiscard]] std::uint32_t side_of(std::uint32_t triangle, std::uint32_t from) const;

  [[nodiscard]] Start start_towards(std::uint32_t from, std::uint32_t to) const;
  void mark_kept(std::uint32_t triangle, std::uint32_t side);
  bool run_through(std::uint32_t from, std::uint32_t to, const Start& start);
  void cut_open(std::uint32_t from, std::uint32_t to);
  void note_rims();
  void fill(std::span<const std::uint32_t> chain);
  void link_all(std::uint64_t kept);
  [[nodiscard]] bool dug(std::uint32_t triangle) const { return dug_[triangle] == round_; }

  std::span<const PlanarPoint> points_;
  std::uint32_t infinite_;  ///< the point at infinity
  std::vector<PlanarTriangle> triangles_;
  std::vector<std::uint32_t> triangle_of_;  ///< per point: one that has it
  std::uint32_t last_ = 0;                  ///< a finite triangle near the last point
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> dug_;     ///< per triangle: the last round in which it was taken out
  std::vector<std::uint32_t> cavity_;  ///< triangles taken out in this round
  std::vector<Rim> rim_;               ///< of the cavity
  std::vector<Link> links_;            ///< sides that are to be neighbours of each other
  std::vector<std::uint64_t> kept_;    ///< edges of the cavity that must be kept
  std::vector<std::uint32_t> left_;    ///< points along the way of an edge, ends included
  std::vector<std::uint32_t> right_;
  std::uint32_t filled_ = 0;  ///< places of the cavity that are used again
};

}  // namespace rad::geom
