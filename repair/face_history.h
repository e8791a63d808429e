// What became of the faces of the input: where each face of the result came from, how far it moved, what is gone.
#pragma once

#include <vector>

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::repair {

/// A face of the result. Faces that differ from their source in nothing have no flag and moved by 0.
struct FaceHistory {
  std::vector<scene::FaceId> sources;  ///< ascending
  bool cut = false;                    ///< its sources have other faces too
  bool divided = false;                ///< the same face, with more vertices along its edges
  bool turned = false;                 ///< looks the other way than the source of one of its triangles
  bool won = false;                    ///< faces lay in it and were removed
  double moved = 0;                    ///< a bound of its distance from its sources, file units; 0 up to rounding
  scene::dvec3 moved_at{0, 0, 0};      ///< file units

  [[nodiscard]] bool merged() const { return sources.size() > 1; }
};

/// A place where more moved than a vertex may.
struct FarRegion {
  scene::dvec3 at{0, 0, 0};  ///< file units, where it is farthest
  double distance = 0;       ///< file units
  std::size_t places = 0;    ///< triangles and points that are farther than allowed
};

struct History {
  std::vector<FaceHistory> faces;   ///< per face of the model
  std::vector<scene::FaceId> gone;  ///< faces of the input that have no face in the result, ascending
  /// No point of the result is farther than this from the input: for each triangle the least over the triangles of its
  /// source of the farthest of its corners, which bounds all its points, for the distance from a triangle is convex.
  /// File units.
  double result_to_input = 0;
  /// The farthest from the result of all corners and middles of triangles of the input, file units: a measurement, not
  /// a bound.
  double input_to_result = 0;
  std::vector<FarRegion> far;  ///< the farthest first
};

/// Neighbouring places are one region within this many T.
inline constexpr double kRegionReach = 16;
/// How far a vertex may move, in T.
inline constexpr double kFarthestMove = 4;

/// `model` is what repair made of `input`, with the origins of its triangles.
History history_of(const scene::Scene& input, const scene::ConformingModel& model);

}  // namespace rad::repair
