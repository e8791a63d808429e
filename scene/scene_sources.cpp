#include "scene/scene_sources.h"

#include <algorithm>

#include "scene/stage_record.h"

namespace rad::scene {

std::vector<SourceRef> sources_of(const Scene& scene, FaceId face) {
  const bool staged = scene.stage && face < scene.stage->sources.size() && !scene.stage->sources[face].empty();
  return staged ? scene.stage->sources[face] : std::vector{scene.faces[face].source};
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
