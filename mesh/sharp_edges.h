// Edges at which a face meets another at less than a right angle: there a point inside the face is nearer to the other
// face than to the edge, and within T of that it would touch a face that has no vertex there.
#pragma once

#include <span>
#include <vector>

#include "geom/box_tree.h"
#include "mesh/face_frame.h"
#include "scene/conforming_model.h"

namespace rad::mesh {

/// An edge of a face's loops or an inner edge, undivided.
struct SharpEdge {
  std::array<scene::PointId, 2> ends{};  ///< points of the model
  double clearance = 0;                  ///< pitches that points inside the face keep from it
};

/// By face. `spacing` (pitches) is what points keep from the other face, so the clearance is spacing / sin of the angle
/// between the faces, times the parts that elements divide a patch into. A face nowhere farther than `spacing` from
/// the plane of the other has nothing to keep: two faces that lie on each other are legal.
std::vector<std::vector<SharpEdge>> sharp_edges(const scene::ConformingModel& model, std::span<const FaceFrame> frames,
                                                double spacing);

/// What points inside a face keep clear of.
class ClearZone {
 public:
  ClearZone(const scene::ConformingModel& model, std::span<const SharpEdge> edges);

  [[nodiscard]] std::span<const SharpEdge> edges() const { return edges_; }
  /// Whether a point of the face's plane keeps its distance from all of them.
  [[nodiscard]] bool leaves_out(const geom::LatticePoint& point) const;

 private:
  std::span<const SharpEdge> edges_;
  std::span<const geom::LatticePoint> points_;
  geom::BoxTree tree_;
};

}  // namespace rad::mesh
