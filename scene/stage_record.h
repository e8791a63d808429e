// A model between two filters: how far it has come, in which planes its faces lie, and where they came from.
#pragma once

#include <array>
#include <memory>
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

/// A face, its loops in StageRecord::loops: the outer one first, then holes. Plane, facing and rank count with planes
/// only.
struct StageFace {
  std::uint32_t first_loop = 0;
  std::uint32_t loop_count = 0;
  MaterialId material = 0;
  ObjectId object = 0;
  GroupId group = 0;
  std::uint32_t plane = 0;
  bool along = true;               ///< its front looks where the plane's normal points
  std::uint32_t surface_rank = 0;  ///< of its surface: the least wins where surfaces overlap
  std::vector<SourceRef> sources;  ///< where in the very first input it came from; at least one
  /// The triangles of its plane's map that it covers; empty for none known.
  std::vector<std::array<VertexId, 3>> triangles;
};

/// Without planes the model is only its faces: nothing was grouped yet, or nothing had to be.
struct StageRecord {
  std::string stage;               ///< name of the filter that came last; empty where none ran
  double work_tolerance = 0;       ///< pitches: T, or what the ladder of repair made of it
  bool overlaps_resolved = false;  ///< Coplanar has run: the triangles of all faces meet in edges and corners only
  std::vector<geom::LatticePoint> points;  ///< with planes
  std::vector<dvec3> vertices;             ///< without planes: in file units, as they came in
  std::vector<StagePlane> planes;
  std::vector<VertexId> corners;
  std::vector<Loop> loops;
  std::vector<StageFace> faces;
  std::vector<std::uint32_t> face_of;  ///< per face of the scene (scene_of_stage): the face here
  Ledger ledger;                       ///< of all filters so far

  [[nodiscard]] std::span<const Loop> loops_of(const StageFace& face) const {
    return std::span(loops).subspan(face.first_loop, face.loop_count);
  }
  [[nodiscard]] std::span<const VertexId> corners_of(const Loop& loop) const {
    return std::span(corners).subspan(loop.first, loop.count);
  }
  /// Adds a loop to the face added last.
  void add_loop(std::span<const VertexId> points_of_loop);
};

/// The scene that a record stands for, with the names, unit and axis of `names` and the record in it: its vertices, and
/// of each face the triangles, or the polygon where none are known. Contacts that end inside a polygon would be lost.
/// `lattice` makes places of points. Fills face_of.
Scene scene_of_stage(const Scene& names, StageRecord record, const RecordedLattice& lattice);

}  // namespace rad::scene
