// Where faces came from, through all filters that a model has been through.
#pragma once

#include <vector>

#include "scene/conforming_model.h"
#include "scene/scene.h"

namespace rad::scene {

/// Places in the very first input that a face came from: its own source, or those that its stage file names.
std::vector<SourceRef> sources_of(const Scene& scene, FaceId face);

/// The same for a face of the model that was made of `origin`; each place once, ascending.
std::vector<SourceRef> sources_of(const ConformingModel& model, const ConformingFace& face, const Scene& origin);

/// Faces of the input that a face of the model is made of, ascending: those of its triangles, or the main one where
/// they are not known.
std::vector<FaceId> source_faces(const ConformingModel& model, const ConformingFace& face);

}  // namespace rad::scene
