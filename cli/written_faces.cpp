#include "cli/written_faces.h"

#include <algorithm>

#include "repair/fitness.h"
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
  result.attributes = {};
  result.loops.clear();
  result.corners.clear();
  for (scene::Face& face : result.faces) {
    const std::vector<std::uint32_t> ring = writers::bridged_ring(scene, face);
    face.first_loop = static_cast<std::uint32_t>(result.loops.size());
    face.loop_count = 1;
    result.loops.push_back(
        {static_cast<std::uint32_t>(result.corners.size()), static_cast<std::uint32_t>(ring.size())});
    for (const std::uint32_t corner : ring) result.corners.push_back(scene.corners[corner]);
  }
  return result;
}

std::vector<scene::FaceId> faults_in(const Scene& scene, double tolerance) {
  const geom::ToleranceRequest asked{tolerance, geom::ToleranceRequest::Measure::FileUnits};
  std::vector<scene::FaceId> faults =
      repair::faces_at_fault(scene, asked, {validate::Stage::Model, validate::Stage::Display});
  std::string refusal;
  const auto context = validate::build_context(scene, {}, asked, refusal);
  for (scene::FaceId face = 0; context && face < scene.faces.size(); ++face) {
    const bool simple = context->triangles.flaw[face] == validate::RingFlaw::None;
    if (!simple || !context->is_sound(face)) faults.push_back(face);
  }
  return faults;
}

}  // namespace

std::vector<bool> faces_with_inner_edges(const scene::ConformingModel& model) {
  std::vector<bool> faces;
  for (const scene::ConformingFace& face : model.faces) faces.push_back(face.inner_edge_count > 0);
  return faces;
}

scene::PiecesOfModel faces_to_write(const scene::ConformingModel& model, const Scene& origin) {
  std::vector<bool> as_triangles = faces_with_inner_edges(model);
  for (int round = 0; round < kRounds; ++round) {
    scene::PiecesOfModel pieces = scene::pieces_of(model, origin, as_triangles);
    bool changed = false;
    for (const scene::FaceId face : faults_in(bridged(pieces.scene), model.tolerance.length)) {
      changed |= !as_triangles[pieces.face[face]];
      as_triangles[pieces.face[face]] = true;
    }
    if (!changed) return pieces;
  }
  return scene::pieces_of(model, origin, std::vector<bool>(model.faces.size(), true));
}

}  // namespace rad::cli
