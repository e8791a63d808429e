// What of the input is not in the result: faces that closed to lines, plates that became flat. Nothing is lost without
// a word.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "repair/coplanar_log.h"
#include "repair/maximal_faces.h"
#include "scene/ledger.h"
#include "validate/context.h"

namespace rad::repair {

/// What the triangles of a result say of the faces of the input.
class Remains {
 public:
  Remains() = default;
  /// The sources of `triangles` are faces of the input, which has `face_count`.
  Remains(const PlanarTriangles& triangles, std::size_t face_count);

  /// Whether a triangle of the face is left.
  [[nodiscard]] bool left(scene::FaceId face) const { return left_[face]; }
  /// Whether triangles of both lie on each other back to back.
  [[nodiscard]] bool joined(scene::FaceId a, scene::FaceId b) const;

 private:
  std::vector<bool> left_;
  std::vector<std::array<scene::FaceId, 2>> joined_;  ///< ascending, each pair the same
};

/// Ledger of what was lost of `input`, with places, largest area first:
/// "drop-degenerate": faces that had no area at T to begin with (RL007);
/// "close-face": faces of which nothing is left though nothing covers them, for they were too narrow;
/// "flatten-plate", "close-slit": thin features (RL107), up to what the ladder may weld, whose two sides lie on each
/// other now.
scene::Ledger losses(const validate::Context& input, const Remains& remains, const CoplanarLog& covered);

}  // namespace rad::repair
