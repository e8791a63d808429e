// Wanted patch lengths along the edges of a model: small near short edges and in narrow places, growing gradually to
// the longest patch edge (the open problem of paper 3.4.1).
#pragma once

#include <span>
#include <vector>

#include "mesh/edge_division.h"
#include "mesh/face_outline.h"

namespace rad::mesh {

/// Sizes grow by at most this share of the way along edges and across faces.
inline constexpr double kSizeSlope = 0.35;

/// A wanted length at a place of an edge; both in pitches, the place from its first end.
struct SizedPlace {
  double place = 0;
  double size = 0;
};

/// Per edge of an EdgeDivision, in its order.
class EdgeSizes {
 public:
  void begin_edge() { first_.push_back(static_cast<std::uint32_t>(places_.size())); }
  void add(const SizedPlace& place) { places_.push_back(place); }
  [[nodiscard]] bool empty() const { return first_.empty(); }
  [[nodiscard]] std::span<const SizedPlace> of(std::size_t edge) const {
    const std::size_t end = edge + 1 < first_.size() ? first_[edge + 1] : places_.size();
    return std::span(places_).subspan(first_[edge], end - first_[edge]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<SizedPlace> places_;
};

/// Sizes at the points of `division`: at most the longest edge of the faces there, 1.5 times the shortest edge of a
/// face at a point (needles apart), 1.4 times the distance of edges of one face that do not meet, and what the slope
/// lets grow from all of these. `outlines` are the faces of the model as `division` divides them. The minimum over all
/// sources: it does not depend on any order.
EdgeSizes edge_sizes(const scene::ConformingModel& model, const EdgeDivision& division,
                     std::span<const FaceOutline> outlines);

/// Places strictly between `from` and `to`, and these two, that part the way so that each part has about its wanted
/// length, none more than `longest`; as many as `least_parts`, but none shorter on average than `spacing`. Pitches.
std::vector<double> graded_places(std::span<const SizedPlace> sizes, double from, double to, double longest,
                                  std::uint32_t least_parts, double spacing);

}  // namespace rad::mesh
