// What hard scenes are drawn with: polygons, boxes, tubes, random numbers and rigid motions.
#pragma once

#include <glm/mat3x3.hpp>
#include <string>
#include <vector>

#include "corpus/random.h"
#include "geom/vec.h"
#include "scene/scene.h"

namespace rad::corpus {

using geom::dvec3;
using Corners = std::vector<dvec3>;

/// A polygon; every corner becomes a vertex of its own.
struct SketchFace {
  Corners outer;
  std::vector<Corners> holes;
  int material = 0;
};

/// Upright, axis-parallel, counter-clockwise seen from above.
Corners rectangle(double x0, double y0, double x1, double y1, double z);
Corners reversed(const Corners& corners);
glm::dmat3 about_z(double angle);

/// Parts are drawn about 1 wide, near the origin, and off each other by shares of `tolerance`.
class HardSketch {
 public:
  /// `size`: how many times as many parts as a small scene has; at least 1.
  HardSketch(std::uint64_t seed, double tolerance, int size) : random_(seed), tolerance_(tolerance), size_(size) {}

  [[nodiscard]] Random& random() { return random_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::vector<SketchFace>& faces() { return faces_; }

  // Random things.
  int parts(int low, int high) { return random_.between(low, high) * size_; }
  /// In [-share, share) times the tolerance.
  double noise(double share) { return share * tolerance_ * random_.real(-1, 1); }
  dvec3 anywhere(double extent);
  dvec3 noise_vector(double share);
  glm::dmat3 rotation();
  dvec3 direction() { return rotation()[0]; }
  int material() { return random_.between(0, 2); }

  // Drawing.
  void add(Corners outer, int material) { faces_.push_back({std::move(outer), {}, material}); }
  void add_with_holes(Corners outer, std::vector<Corners> holes, int material);
  void add_either_way(const Corners& corners);
  /// One time in three as two triangles.
  void add_maybe_cut(const Corners& quad, int material);
  void box(const dvec3& low, const dvec3& high, int material);
  /// A tube without ends around `centre`, along z.
  void tube(const dvec3& centre, double radius, double half_length, int sides, int material);

  // What is drawn from face `first` on.
  [[nodiscard]] std::size_t drawn() const { return faces_.size(); }
  void transform(std::size_t first, const glm::dmat3& turn, const dvec3& by);
  void turn_freely(std::size_t first);
  void maybe_turn(std::size_t first);
  /// Not at all, by an angle with rational sine and cosine, or in any way.
  void turn_somehow(std::size_t first);
  /// The same once more, moved.
  void copy(std::size_t first, const dvec3& by);

  /// What is drawn, as one object of materials "material0"…, with faces counted as lines.
  [[nodiscard]] scene::Scene scene() const;

 private:
  Random random_;
  double tolerance_;
  int size_;
  std::vector<SketchFace> faces_;
};

}  // namespace rad::corpus
