// What welding may flatten or close: plates and slits thinner than the weld distance, strips narrower than 2 T. Looked
// for before anything is welded, so that no pane, blind or sheet is lost without a word.
#pragma once

#include <vector>

#include "validate/context.h"
#include "validate/violation.h"

namespace rad::validate {

enum class ThinKind : std::uint8_t {
  Plate,  ///< two sides of a part with material between them, nearer than the weld distance
  Slit,   ///< two sides of a part that look at each other from nearer than the weld distance
  Strip,  ///< a face, or faces of one plane together, narrower than 2 T and longer than twice that
};

struct ThinFeature {
  std::array<FaceId, 2> faces{kNoFace, kNoFace};  ///< by Context::precedes; a strip has one
  ThinKind kind = ThinKind::Plate;
  double thickness = 0;  ///< pitches, where it is thinnest
  double area = 0;       ///< pitches²: of the overlap of the two sides, or of the strip
  dvec3 point{0, 0, 0};  ///< lattice units

  /// The largest T, in pitches, that keeps this apart, rims too; below geom::kRefusedBelowPitches none does.
  [[nodiscard]] double kept_pitches() const;
};

/// A strip is narrower than this, in T.
inline constexpr std::int64_t kStripTolerances = 2;
/// And longer than this.
inline constexpr std::int64_t kStripLengthTolerances = 4;

/// Plates and slits whose sides are at most `reach` pitches apart, by their faces. Two sides are near-parallel
/// triangles of one part (parts.h) that look opposite ways and overlap in a region more than T/2 wide on average; sides
/// that coincide are no plate (RL114, RL222). Parallel; O(n log n + pairs).
std::vector<ThinFeature> find_facing_sides(const Context& context, std::int64_t reach);

/// Strips, by their faces.
std::vector<ThinFeature> find_strips(const Context& context);

/// Plates and slits up to the weld distance, then strips.
std::vector<ThinFeature> find_thin_features(const Context& context);

}  // namespace rad::validate
