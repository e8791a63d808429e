#include "repair/fitness.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <numeric>

#include "repair/input_soup.h"
#include "repair/plane_groups.h"
#include "repair/triangle_lint.h"
#include "validate/lint.h"
#include "validate/registry.h"
#include "validate/rules.h"

namespace rad::repair {
namespace {

// Rings that cross are cut into what an odd number of them encloses, though lint leaves the choice to the author.
bool curable(const validate::Rule& rule) {
  return rule.fix == scene::FixClass::Safe || &rule == &validate::ring_defect;
}

bool may_be_at_fault(const validate::Rule& rule) {
  const auto is_error = [&](validate::Stage stage) {
    return validate::severity_at(rule, stage) == scene::Severity::Error;
  };
  return rule.check != nullptr && curable(rule) &&
         (is_error(validate::Stage::Model) || is_error(validate::Stage::Display));
}

}  // namespace

PlanarTriangles planar_triangles(const validate::Context& context) {
  const Soup soup = input_soup(context, std::vector<std::uint32_t>(context.scene.faces.size(), 0));
  PlanarTriangles set;
  set.points = soup.points;
  set.members.reserve(soup.pieces.size());
  for (const SoupPiece& piece : soup.pieces) {
    const auto edges = soup.edges_of(piece);
    set.members.push_back({{edges[0][0], edges[1][0], edges[2][0]}, kNoCluster, true, piece.source});
  }
  group_by_planes(set, static_cast<double>(context.tolerance.pitches));
  return set;
}

namespace {

// Nothing is known of how these triangles lie in their planes.
std::vector<Triangle> without_planes(const PlanarTriangles& set) {
  std::vector<Triangle> triangles;
  triangles.reserve(set.members.size());
  for (const auto& member : set.members) triangles.push_back({member.points, kNoCluster, member.along, 0, 0});
  return triangles;
}

// Contacts only where nothing worse is there.
std::vector<Violation> violations_of(TriangleLint& lint, const TriangleSet& set) {
  std::vector<Violation> found = lint.violations(set);
  if (!found.empty()) return found;
  lint.update_contacts(set);
  return lint.contacts();
}

}  // namespace

std::vector<Violation> violations_of(const PlanarTriangles& set, std::int64_t tolerance) {
  const std::vector<Triangle> triangles = without_planes(set);
  std::vector<std::uint32_t> all(triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  TriangleLint lint(tolerance);
  lint.update({set.points, triangles, {}, {}}, all);
  return violations_of(lint, {set.points, triangles, {}, {}});
}

std::vector<Violation> violations_of(const PlanarTriangles& set, std::int64_t tolerance,
                                     std::span<const std::uint32_t> turned) {
  const std::vector<Triangle> triangles = without_planes(set);
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (!std::ranges::binary_search(turned, i)) others.push_back(i);
  }
  TriangleLint lint(tolerance);
  lint.trust({set.points, triangles, {}, {}}, others);
  lint.update({set.points, triangles, {}, {}}, turned);
  return violations_of(lint, {set.points, triangles, {}, {}});
}

std::size_t broken_rules(const validate::Context& context) {
  std::size_t broken = 0;
  for (const validate::Rule* rule : validate::all_rules()) {
    if (!may_be_at_fault(*rule)) continue;
    validate::Violations violations;
    rule->check(context, violations);
    broken += violations.items.size();
  }
  return broken;
}

std::vector<scene::FaceId> faces_at_fault(const scene::Scene& scene,
                                          const std::optional<geom::ToleranceRequest>& tolerance,
                                          std::initializer_list<validate::Stage> stages) {
  const auto is_error = [&](const validate::Rule& rule) {
    return std::ranges::any_of(stages, [&](validate::Stage stage) {
      return validate::severity_at(rule, stage) == scene::Severity::Error;
    });
  };
  const scene::ReadIssues none;
  std::string refusal;
  std::vector<scene::FaceId> faces;
  const auto context = validate::build_context(scene, none, tolerance, refusal);
  if (!context) return faces;
  for (const validate::Rule* rule : validate::all_rules()) {
    if (rule->check == nullptr || rule->fix != scene::FixClass::Safe || !is_error(*rule)) continue;
    validate::Violations violations;
    rule->check(*context, violations);
    for (const validate::Violation& violation : violations.items) {
      for (const scene::FaceId face : violation.faces) {
        if (face != validate::kNoFace) faces.push_back(face);
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace rad::repair
