#include "cli/written_faces.h"

#include <algorithm>

#include "repair/fitness.h"
#include "scene/repaired_scene.h"
#include "validate/context.h"
#include "writers/bridged_ring.h"

namespace rad::cli {
namespace {

using scene::Scene;

// Triangles instead of one face may put its neighbours at fault. Then all are triangles, as in GLB.
constexpr int kRounds = 4;

// As formats without holes give the faces back.
Scene bridged(const Scene& scene) {
  Scene result = scene;
  result.loops.clear();
  result.corners.clear();
  for (scene::Face& face : result.faces) {
    const std::vector<scene::VertexId> ring = writers::bridged_ring(scene, face);
    face.first_loop = static_cast<std::uint32_t>(result.loops.size());
    face.loop_count = 1;
    result.loops.push_back(
        {static_cast<std::uint32_t>(result.corners.size()), static_cast<std::uint32_t>(ring.size())});
    result.corners.insert(result.corners.end(), ring.begin(), ring.end());
  }
  return result;
}

std::vector<scene::FaceId> faults_in(const Scene& scene, double tolerance) {
  const geom::ToleranceRequest asked{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  std::vector<scene::FaceId> faults = repair::faces_at_fault(scene, asked, validate::Stage::Model);
  const auto shown = repair::faces_at_fault(scene, asked, validate::Stage::Display);
  faults.insert(faults.end(), shown.begin(), shown.end());
  std::string refusal;
  const auto context = validate::build_context(scene, {}, asked, refusal);
  for (scene::FaceId face = 0; context && face < scene.faces.size(); ++face) {
    const bool simple = context->triangles.flaw[face] == validate::RingFlaw::None;
    if (!simple || !context->is_sound(face)) faults.push_back(face);
  }
  return faults;
}

// Per face of the scene, the face of the model that it comes from.
std::vector<std::size_t> origins(const scene::ConformingModel& model, const std::vector<bool>& whole) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    result.insert(result.end(), whole[i] ? 1 : model.faces[i].triangle_count, i);
  }
  return result;
}

}  // namespace

Scene faces_to_write(const scene::ConformingModel& model, const Scene& origin) {
  std::vector<bool> whole;
  for (const scene::ConformingFace& face : model.faces) whole.push_back(face.inner_edge_count == 0);
  for (int round = 0; round < kRounds; ++round) {
    Scene scene = scene::repaired_scene(model, origin, whole);
    const std::vector<std::size_t> origin_of = origins(model, whole);
    bool changed = false;
    for (const scene::FaceId face : faults_in(bridged(scene), model.tolerance.length)) {
      changed |= whole[origin_of[face]];
      whole[origin_of[face]] = false;
    }
    if (!changed) return scene;
  }
  return scene::repaired_scene(model, origin, scene::Pieces::Triangles);
}

}  // namespace rad::cli
