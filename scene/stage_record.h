// What a model between two filters has beyond a scene: how far it has come, and in which planes its faces lie.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geom/vec.h"
#include "scene/ledger.h"
#include "scene/scene.h"

namespace rad::scene {

/// A plane that faces were grouped into.
struct StagePlane {
  dvec3 normal{0, 0, 1};                       ///< unit length
  double offset = 0;                           ///< pitches
  double area = 0;                             ///< of the faces it was led by, pitches²
  std::vector<std::array<VertexId, 2>> slits;  ///< edges drawn in where something of another plane touches
  std::vector<VertexId> points;                ///< points drawn in
};

struct StageFace {
  std::uint32_t plane = 0;
  bool along = true;               ///< its front looks where the plane's normal points
  std::uint32_t surface_rank = 0;  ///< of its surface: the least wins where surfaces overlap
};

/// `faces` and `sources` run parallel to the faces of the scene that holds the record, `points` to its vertices.
/// Without planes the model is only the faces: nothing was grouped yet, or nothing had to be.
struct StageRecord {
  std::string stage;                      ///< name of the filter that came last; empty where none ran
  double work_tolerance = 0;              ///< pitches: T, or what the ladder of repair made of it
  std::vector<geom::LatticePoint> points;
  std::vector<StagePlane> planes;
  std::vector<StageFace> faces;           ///< empty without planes
  /// The triangles of each face; empty before overlaps are resolved.
  std::vector<std::vector<std::array<VertexId, 3>>> triangles;
  std::vector<std::vector<SourceRef>> sources;  ///< per face: where in the very first input it came from
  Ledger ledger;                                ///< of all filters so far
};

}  // namespace rad::scene
