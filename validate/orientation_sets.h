// Faces that neighbours tie together: of each set all or none has to be turned, once it agrees in itself (1b).
#pragma once

#include <array>
#include <vector>

#include "validate/context.h"

namespace rad::validate {

struct OrientationSet {
  std::vector<FaceId> faces;  ///< ascending
  bool orientable = true;     ///< false where no turning makes all neighbours agree: a Möbius strip
};

struct OrientationSets {
  std::vector<std::uint32_t> set_of_face;  ///< faces without area are sets of their own
  std::vector<std::uint8_t> parity;        ///< per face: 0 or 1; equal within a set where two faces look the same way
  std::vector<OrientationSet> sets;        ///< by their smallest face
  /// Faces that neighbours tie together and that no turning makes agree, ascending. In `sets` they are parted into what
  /// edges of two faces tie together.
  std::vector<std::vector<FaceId>> one_sided;
  std::vector<std::uint8_t> is_one_sided;  ///< per face: it is of one of those
};

/// Joins neighbours (neighbours.h) with the parity of their agreement. Two faces that run one way along their edge and
/// are parallel lie on each other, such as a rug flush with its floor: they are no neighbours. Which faces are neighbours
/// at an edge of more than two is a guess by their objects: where it leads to a surface with one side only it is not
/// believed, and what it had tied together has to agree by the other edges alone.
OrientationSets find_orientation_sets(const Context& context);

/// Neighbours that look opposite ways along a subedge.
struct Disagreement {
  const Subedge* subedge = nullptr;  ///< of Context::topology
  std::array<FaceId, 2> faces{};
};

/// All but those that no turning makes agree.
std::vector<Disagreement> disagreements_of(const Context& context);

}  // namespace rad::validate
