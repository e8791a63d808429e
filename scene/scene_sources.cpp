#include "scene/scene_sources.h"

#include <algorithm>

#include "scene/stage_record.h"

namespace rad::scene {

std::vector<SourceRef> sources_of(const Scene& scene, FaceId face) {
  if (!scene.stage || face >= scene.stage->face_of.size()) return {scene.faces[face].source};
  return scene.stage->faces[scene.stage->face_of[face]].sources;
}

std::vector<SourceRef> sources_of(const ConformingModel& model, const ConformingFace& face, const Scene& origin) {
  std::vector<SourceRef> all;
  for (const FaceId source : source_faces(model, face)) {
    const std::vector<SourceRef> more = sources_of(origin, source);
    all.insert(all.end(), more.begin(), more.end());
  }
  std::ranges::sort(all);
  const auto repeated = std::ranges::unique(all);
  all.erase(repeated.begin(), repeated.end());
  return all;
}

std::vector<FaceId> source_faces(const ConformingModel& model, const ConformingFace& face) {
  if (model.origins.empty()) return {face.source};
  std::vector<FaceId> sources;
  for (const TriangleOrigin& origin : model.origins_of(face)) sources.push_back(origin.source);
  std::ranges::sort(sources);
  const auto repeated = std::ranges::unique(sources);
  sources.erase(repeated.begin(), repeated.end());
  return sources;
}

}  // namespace rad::scene
