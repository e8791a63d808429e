#include "repair/orientation.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/corner_rows.h"
#include "validate/facing.h"
#include "validate/orientation_sets.h"
#include "validate/rules.h"

namespace rad::repair {
namespace {

using geom::dvec3;
using scene::FaceId;

// Of two halves the smaller by area; of equal ones that without the face that comes first in space.
std::uint8_t smaller_half(const validate::Context& context, const std::vector<FaceId>& faces,
                          const std::vector<std::uint8_t>& parity) {
  std::array<double, 2> area{};
  for (const FaceId face : faces) area[parity[face]] += glm::length(context.triangles.normal[face]);
  if (area[0] != area[1]) return area[1] > area[0] ? 0 : 1;
  const FaceId least =
      *std::min_element(faces.begin(), faces.end(), [&](FaceId a, FaceId b) { return context.precedes(a, b); });
  return static_cast<std::uint8_t>(1 - parity[least]);
}

std::vector<FaceId> minority_faces(const validate::Context& context) {
  const validate::OrientationSets orientation = validate::find_orientation_sets(context);
  std::vector<FaceId> turn;
  for (const validate::OrientationSet& set : orientation.sets) {
    const auto differs = [&](FaceId face) { return orientation.parity[face] != orientation.parity[set.faces[0]]; };
    if (!set.orientable || std::ranges::none_of(set.faces, differs)) continue;
    const std::uint8_t smaller = smaller_half(context, set.faces, orientation.parity);
    for (const FaceId face : set.faces) {
      if (orientation.parity[face] == smaller) turn.push_back(face);
    }
  }
  std::sort(turn.begin(), turn.end());
  return turn;
}

std::vector<FaceId> inside_out_faces(const validate::Context& context) {
  validate::Violations violations;
  validate::inside_out_solid.check(context, violations);
  std::vector<bool> inward(context.topology.components.size(), false);
  for (const validate::Violation& violation : violations.items) {
    inward[context.topology.component_of_face[violation.faces[0]]] = true;
  }
  std::vector<FaceId> faces;
  for (FaceId face = 0; face < context.scene.faces.size(); ++face) {
    const std::uint32_t component = context.topology.component_of_face[face];
    if (component != validate::kNoComponent && inward[component]) faces.push_back(face);
  }
  return faces;
}

// Those whose fronts lie in the dark and whose backs lie in light (RL112).
std::vector<FaceId> faces_turned_over(const validate::Context& context) {
  std::vector<FaceId> faces;
  if (!validate::may_face_away(context)) return faces;
  const auto space = validate::find_lit_space(context);
  if (!space) return faces;
  for (const std::vector<FaceId>& set : validate::sets_facing_away(context, *space)) {
    faces.insert(faces.end(), set.begin(), set.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

// From the same first corner backward. What no corner has stays empty.
void turn_loop(std::vector<std::uint32_t>& of_corners, const scene::Loop& loop) {
  if (of_corners.empty() || loop.count < 2) return;
  const auto first = of_corners.begin() + loop.first;
  std::reverse(first + 1, first + loop.count);
}

void negate_normal(scene::CornerValues<dvec3>& normals, std::size_t corner, scene::CornerRows<dvec3>& rows) {
  const scene::RowId row = normals.row(corner);
  if (row != scene::kNoRow) normals.row_of_corner[corner] = rows.row(-normals.table[row]);
}

}  // namespace

std::vector<FaceId> faces_to_turn(const validate::Context& context) {
  std::vector<FaceId> turn = minority_faces(context);
  if (turn.empty()) turn = inside_out_faces(context);
  return turn.empty() ? faces_turned_over(context) : turn;
}

scene::Scene turned(scene::Scene scene, const std::vector<FaceId>& faces) {
  scene::CornerAttributes& attributes = scene.attributes;
  scene::CornerRows<dvec3> normals(attributes.normals.table);
  for (const FaceId face : faces) {
    for (const scene::Loop& loop : scene.loops_of(scene.faces[face])) {
      turn_loop(scene.corners, loop);
      turn_loop(attributes.texture_coordinates.row_of_corner, loop);
      turn_loop(attributes.normals.row_of_corner, loop);
      for (std::size_t i = loop.first; i < loop.first + loop.count; ++i) negate_normal(attributes.normals, i, normals);
    }
  }
  return scene;
}

Oriented orient(scene::Scene& scene, const scene::ReadIssues& issues,
                const std::optional<geom::ToleranceRequest>& tolerance) {
  Oriented result;
  std::string refusal;
  std::optional<validate::Context> context = validate::build_context(scene, issues, tolerance, refusal);
  // First neighbours, then whole objects, then lamps, then what they light; turning an object may make another one a
  // room.
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds && context; ++round) {
    const std::vector<FaceId> turn = faces_to_turn(*context);
    if (turn.empty()) break;
    std::vector<FaceId> both;
    std::ranges::set_symmetric_difference(result.turned, turn, std::back_inserter(both));
    result.turned = std::move(both);
    scene = turned(std::move(scene), turn);
    validate::Context after = validate::context_after_turning(std::move(*context), scene, turn);
    context.emplace(std::move(after));
  }
  if (context) result.context.emplace(std::move(*context));
  return result;
}

}  // namespace rad::repair
