// Faces flat enough to be divided anew.
#pragma once

#include "scene/conforming_model.h"

namespace rad::mesh {

/// A face whose points lie within this share of T of one plane, or within two pitches, is flat.
inline constexpr double kFlatShare = 1.0 / 16;

/// The model with every face that is not flat replaced by the triangles of its triangulation. Repair has shown those to
/// be apart from all else by T; other triangles between the same points would lie elsewhere by as much as the points
/// are off their plane.
scene::ConformingModel with_flat_faces(const scene::ConformingModel& model);

}  // namespace rad::mesh
