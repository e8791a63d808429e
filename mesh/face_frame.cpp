#include "mesh/face_frame.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace rad::mesh {
namespace {

using geom::dvec3;

// Below 2^51 in each component, since the triangles of a face do not overlap in projection.
geom::IntVector doubled_area_vector(const scene::ConformingModel& model, const scene::ConformingFace& face) {
  geom::IntVector sum;
  for (const auto& t : model.triangles_of(face)) {
    const auto& a = model.points[t[0]];
    const auto n = geom::cross(geom::difference(model.points[t[1]], a), geom::difference(model.points[t[2]], a));
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  return sum;
}

dvec3 mean_corner(const scene::ConformingModel& model, const scene::ConformingFace& face) {
  dvec3 sum(0, 0, 0);
  double count = 0;
  for (const scene::Loop& loop : model.loops_of(face)) {
    for (const scene::PointId point : model.corners_of(loop)) {
      sum += geom::as_vector(model.points[point]);
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

FaceFrame::FaceFrame(const scene::ConformingModel& model, const scene::ConformingFace& face) {
  const geom::IntVector sum = doubled_area_vector(model, face);
  const dvec3 vector(static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z));
  doubled_area_ = glm::length(vector);
  if (!has_area()) return;
  normal_ = vector / doubled_area_;
  view_ = FlatView(vector);
  origin_ = mean_corner(model, face);
}

void FaceFrame::align(const geom::LatticePoint& from, const geom::LatticePoint& to) {
  const dvec3 way = geom::as_vector(to) - geom::as_vector(from);
  along_ = glm::normalize(way - normal_ * glm::dot(way, normal_));
  across_ = glm::cross(normal_, along_);
}

geom::PlanePoint FaceFrame::in_plane(const geom::LatticePoint& point) const {
  const dvec3 offset = geom::as_vector(point) - origin_;
  return {glm::dot(offset, along_), glm::dot(offset, across_)};
}

geom::LatticePoint FaceFrame::nearest(const geom::PlanePoint& point) const {
  const int dropped = view_.dropped();
  dvec3 place = origin_ + along_ * point.x + across_ * point.y;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != dropped) place[axis] = std::round(place[axis]);
  }
  dvec3 offset = place - origin_;
  offset[dropped] = 0;
  place[dropped] = std::round(origin_[dropped] - glm::dot(normal_, offset) / normal_[dropped]);
  return {static_cast<std::int32_t>(place.x), static_cast<std::int32_t>(place.y), static_cast<std::int32_t>(place.z)};
}

}  // namespace rad::mesh
