// A face's plane: the exact projection onto the lattice plane that it faces most, and the metric of the plane itself.
#pragma once

#include "geom/planar_shape.h"
#include "mesh/flat_view.h"
#include "scene/conforming_model.h"

namespace rad::mesh {

class FaceFrame {
 public:
  /// The plane through the mean of the face's points with the normal of its whole area. The face must have area.
  FaceFrame(const scene::ConformingModel& model, const scene::ConformingFace& face);

  [[nodiscard]] bool has_area() const { return doubled_area_ > 0; }
  [[nodiscard]] const geom::dvec3& normal() const { return normal_; }
  /// Pitches².
  [[nodiscard]] double area() const { return doubled_area_ / 2; }

  /// Lets the x axis of plane coordinates run from `from` towards `to`, two points of the face.
  void align(const geom::LatticePoint& from, const geom::LatticePoint& to);

  /// Exact; a loop that is counter-clockwise seen from the front is counter-clockwise here.
  [[nodiscard]] geom::PlanarPoint flat(const geom::LatticePoint& point) const { return view_.of(point); }
  /// In an orthonormal frame of the plane, pitches.
  [[nodiscard]] geom::PlanePoint in_plane(const geom::LatticePoint& point) const;
  /// The lattice point nearest to a point of the plane along the axis that the face faces most.
  [[nodiscard]] geom::LatticePoint nearest(const geom::PlanePoint& point) const;

 private:
  geom::dvec3 normal_{0, 0, 1};
  double doubled_area_ = 0;
  geom::dvec3 origin_{0, 0, 0};
  geom::dvec3 along_{1, 0, 0};
  geom::dvec3 across_{0, 1, 0};
  FlatView view_;
};

}  // namespace rad::mesh
