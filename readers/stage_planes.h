// Whether the planes of a stage file can be what its faces were grouped into.
#pragma once

#include "scene/scene.h"
#include "scene/stage_record.h"

namespace rad::readers {

/// True where points differ, normals are of unit length, all corners and triangles lie near the plane of their face,
/// triangles face as it does, and no two triangles of one plane and facing have an edge the same way. `tolerance`: T in
/// pitches. Indices of the record must be within range.
bool planes_fit(const scene::Scene& scene, const scene::StageRecord& record, double tolerance);

}  // namespace rad::readers
