#include "repair/fitness.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>

#include "repair/input_soup.h"
#include "repair/leader_planes.h"
#include "validate/lint.h"
#include "validate/rules.h"

namespace rad::repair {
namespace {

// As after snapping: what lies within this share of T of a plane is in it.
constexpr double kPlaneBand = 0.5;

// Rings that cross are cut into what an odd number of them encloses, though lint leaves the choice to the author.
bool curable(const scene::Finding& finding) {
  return finding.fix.applicability == scene::FixClass::Safe || finding.rule == validate::ring_defect.id;
}

bool has_errors(const validate::LintResult& result) {
  return std::ranges::any_of(result.findings, [](const scene::Finding& finding) {
    return finding.severity == scene::Severity::Error && curable(finding);
  });
}

}  // namespace

PlanarTriangles planar_triangles(const validate::Context& context) {
  const Soup soup = input_soup(context);
  const auto tolerance = static_cast<double>(context.tolerance.pitches);
  const PlaneClaims claims = claim_planes(soup, kPlaneBand * tolerance, tolerance);
  PlanarTriangles set;
  set.points = soup.points;
  for (const LeaderPlane& leader : claims.leaders) set.planes.push_back(leader.plane);
  for (std::size_t i = 0; i < soup.pieces.size(); ++i) {
    const SoupPiece& piece = soup.pieces[i];
    const auto edges = soup.edges_of(piece);
    const ClusterId cluster = claims.leader_of_piece[i];
    const bool along = glm::dot(soup.normal_of(piece), set.planes[cluster].normal) > 0;
    set.members.push_back({{edges[0][0], edges[1][0], edges[2][0]}, cluster, along, piece.source});
  }
  return set;
}

std::vector<Violation> violations_of(const PlanarTriangles& set, std::int64_t tolerance) {
  std::vector<Triangle> triangles;
  triangles.reserve(set.members.size());
  for (const auto& member : set.members) triangles.push_back({member.points, member.cluster, member.along, 0, 0});
  // Nothing is known of how these triangles lie in their planes.
  const auto folded = std::make_unique<bool[]>(set.planes.size());
  std::fill_n(folded.get(), set.planes.size(), true);
  return lint_triangles({set.points, triangles, {folded.get(), set.planes.size()}}, tolerance);
}

bool breaks_rules(const scene::Scene& scene, const scene::ReadIssues& issues,
                  const std::optional<geom::ToleranceRequest>& tolerance) {
  for (const validate::Stage stage : {validate::Stage::Model, validate::Stage::Display}) {
    validate::LintOptions options;
    options.stage = stage;
    options.tolerance = tolerance;
    if (has_errors(validate::lint(scene, issues, options))) return true;
  }
  return false;
}

}  // namespace rad::repair
