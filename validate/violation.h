// One breach of one rule, as a check reports it: small, without text. Grouping turns violations into findings.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace rad::validate {

using geom::dvec3;
using scene::FaceId;

inline constexpr FaceId kNoFace = 0xffffffffu;
inline constexpr scene::VertexId kNoVertex = 0xffffffffu;

struct Violation {
  std::array<FaceId, 2> faces{kNoFace, kNoFace};  ///< participants; the first is where the fault is located
  std::optional<dvec3> point;                     ///< file units; nothing for a fault without a finite place
  std::optional<std::array<dvec3, 2>> segment;    ///< file units
  double measure = 0;                             ///< in the unit of the rule; the largest |badness| leads a cluster
  scene::VertexId vertex = kNoVertex;             ///< raw vertex at fault, for its line in the file
  double area = 0;                                ///< file units², of a fault with extent; a finding adds them up
  std::optional<double> kept_below;               ///< largest T, file units, at which it is none; 0 where there is none
  std::uint64_t count = 1;                        ///< like violations that this one stands for
  /// Violations of one rule with the same participants and the same nonzero cluster key belong to one finding; 0
  /// leaves grouping to shared faces.
  std::uint64_t cluster = 0;
  bool grave = false;  ///< of its rule's grave_at_solve
  /// Fills {detail} of the rule's message: a literal, a name of the scene, or a text that Violations keeps.
  std::string_view detail;
};

}  // namespace rad::validate
