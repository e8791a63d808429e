// Faces flat enough to be divided anew.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/conforming_model.h"

namespace rad::mesh {

/// A face whose points lie within this share of T of one plane, or within two pitches, is flat.
inline constexpr double kFlatShare = 1.0 / 16;

/// Per face whether it is flat.
std::vector<bool> flat_faces(const scene::ConformingModel& model);

/// A model and where its faces come from.
struct DividedModel {
  scene::ConformingModel model;
  std::vector<std::uint32_t> origin;  ///< per face: the face that it is, or is a triangle of
};

/// The model with the faces that are not `kept` replaced by the triangles of their triangulation. Repair has shown
/// those to be apart from all else by T; other triangles between the same points would lie elsewhere by as much as the
/// points are off their plane.
DividedModel with_triangles(const DividedModel& divided, const std::vector<bool>& kept);

}  // namespace rad::mesh
