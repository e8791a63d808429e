// Lines of sight from the backs of a surface to lit fronts and to open space: found by rays, proved by integers.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "geom/box_tree.h"
#include "validate/lit_space.h"

namespace rad::validate {

/// The back of a face on one side of a triangle of LitSpace::sheets.
struct BackSide {
  std::uint32_t triangle = 0;
  int side = 0;
};

/// A segment that passes through no triangle and, but for those that share a corner with the two at its ends, comes
/// within T of none.
struct SightLine {
  std::array<dvec3, 2> ends{};  ///< lattice units; from the lit front, or from open space, to the back
  FaceId back = kNoFace;
  FaceId front = kNoFace;  ///< kNoFace where it starts in open space
};

class SightLines {
 public:
  /// Both must outlive it.
  SightLines(const Context& context, const LitSpace& space);

  /// The first of `rays` cosine-weighted rays, area by area over `backs`, that leads to a proven line to a lit front
  /// or, where no material emits, to open space (kNoFace), if `counts` says so of it. The rays are the same in every
  /// run and for every order of the faces.
  [[nodiscard]] std::optional<SightLine> find(std::span<const BackSide> backs, int rays,
                                              const std::function<bool(FaceId front)>& counts) const;

 private:
  class Search;

  const Context& context_;
  const LitSpace& space_;
  geom::BoxTree tree_;
  double farthest_;  ///< longer than the diagonal of the model, pitches
};

}  // namespace rad::validate
