// What is known about a clean scene before a defect is planted: edges, closed objects, distances. Brute force in plain
// floating point, so that it shares no code and no reasoning with the rules it is used to measure.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "corpus/random.h"
#include "geom/lattice.h"
#include "scene/scene.h"

namespace rad::corpus {

using geom::dvec3;
using scene::FaceId;
using scene::VertexId;

/// A stretch of a face's boundary; a bridge that the face runs along both ways is none.
struct EdgeUse {
  FaceId face = 0;
  std::uint32_t loop = 0;    ///< of the face
  std::uint32_t corner = 0;  ///< of the loop, where the edge starts
  bool forward = true;       ///< starts at the lower vertex
};

struct Edge {
  VertexId a = 0, b = 0;  ///< a < b; vertices at equal places count as the first of them
  std::vector<EdgeUse> uses;
};

struct ObjectFacts {
  std::vector<FaceId> faces;
  bool closed = true;         ///< every edge is used twice, in opposite directions
  bool alone = true;          ///< shares no vertex with another object
  bool holds_others = false;  ///< vertices of others lie inside its box
  double volume = 0;
  geom::Box box;
};

/// A point inside a face, `clearance` away from every edge of it and from all other faces.
struct Spot {
  FaceId face = 0;
  dvec3 point{0, 0, 0};
  dvec3 normal{0, 0, 1}, u{1, 0, 0}, v{0, 1, 0};  ///< unit, right-handed, u in a random direction of the plane
  double clearance = 0;
};

class Survey {
 public:
  explicit Survey(const scene::Scene& scene);

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<ObjectFacts>& objects() const { return objects_; }
  /// A length far above any tolerance and below the features of the corpus: a thousandth of the diagonal.
  [[nodiscard]] double grain() const { return grain_; }
  [[nodiscard]] dvec3 normal(FaceId face) const { return normals_[face]; }
  [[nodiscard]] geom::Box box(FaceId face) const;
  [[nodiscard]] std::span<const VertexId> outer(FaceId face) const;
  [[nodiscard]] const dvec3& position(VertexId vertex) const { return scene_.vertices[vertex]; }

  /// One loop, no vertex twice, and every edge shared with exactly one other face, which is of the same object.
  [[nodiscard]] bool is_private(FaceId face) const { return private_[face]; }
  /// Whether the vertex belongs to edges of exactly two faces only.
  [[nodiscard]] bool is_private_vertex(VertexId vertex) const { return !contact_vertex_[vertex]; }
  [[nodiscard]] std::vector<FaceId> faces_at(VertexId vertex) const;

  /// Distance to the nearest face that is not among `skipped`.
  [[nodiscard]] double distance(const dvec3& point, std::span<const FaceId> skipped = {}) const;

  /// The roomiest of some random spots, at least `clearance` wide; nothing where there is none.
  [[nodiscard]] std::optional<Spot> spot(Random& random, double clearance) const;
  /// A spot as above moved off its face to the front, so that a ball of radius `clearance` around it is empty.
  [[nodiscard]] std::optional<Spot> free_spot(Random& random, double clearance) const;

 private:
  void find_edges();
  void find_objects();
  void find_private();
  [[nodiscard]] bool inside(FaceId face, const dvec3& point) const;
  [[nodiscard]] double boundary_distance(FaceId face, const dvec3& point) const;
  [[nodiscard]] double face_distance(FaceId face, const dvec3& point) const;
  [[nodiscard]] std::optional<Spot> random_spot(Random& random, FaceId face) const;

  const scene::Scene& scene_;
  std::vector<VertexId> first_at_;  ///< per vertex: the first at the same place
  std::vector<dvec3> normals_;      ///< unit
  std::vector<Edge> edges_;
  std::vector<ObjectFacts> objects_;
  std::vector<bool> private_;
  std::vector<bool> contact_vertex_;
  double grain_ = 0;
};

}  // namespace rad::corpus
