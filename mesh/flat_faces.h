// Faces flat enough to be divided anew.
#pragma once

#include <vector>

#include "scene/conforming_model.h"

namespace rad::mesh {

/// A face whose points lie within this share of T of one plane, or within two pitches, is flat.
inline constexpr double kFlatShare = 1.0 / 16;

/// Per face whether it is flat.
std::vector<bool> flat_faces(const scene::ConformingModel& model);

/// The model with the faces that are not `kept` replaced by the triangles of their triangulation. Repair has shown those
/// to be apart from all else by T; other triangles between the same points would lie elsewhere by as much as the points
/// are off their plane.
scene::ConformingModel with_triangles(const scene::ConformingModel& model, const std::vector<bool>& kept);

}  // namespace rad::mesh
