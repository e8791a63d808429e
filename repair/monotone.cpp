#include "repair/monotone.h"

#include <algorithm>
#include <set>

#include "validate/context.h"
#include "validate/registry.h"
#include "validate/stage.h"

namespace rad::repair {
namespace {

using Places = std::vector<scene::SourceRef>;

std::size_t sets_of_sources(const scene::Scene& scene, const validate::Violations& violations) {
  std::set<Places> sets;
  for (const validate::Violation& violation : violations.items) {
    Places places;
    for (const scene::FaceId face : violation.faces) {
      if (face != validate::kNoFace) places.push_back(scene.faces[face].source);
    }
    std::ranges::sort(places);
    const auto repeated = std::ranges::unique(places);
    places.erase(repeated.begin(), repeated.end());
    sets.insert(std::move(places));
  }
  return sets.size();
}

}  // namespace

BrokenCounts error_counts(const scene::Scene& scene, const std::optional<geom::ToleranceRequest>& tolerance) {
  return broken_counts(scene, tolerance, [](const validate::Rule& rule) {
    return validate::severity_at(rule, validate::Stage::Model) == scene::Severity::Error;
  });
}

BrokenCounts broken_counts(const scene::Scene& scene, const std::optional<geom::ToleranceRequest>& tolerance,
                           const std::function<bool(const validate::Rule&)>& counts) {
  BrokenCounts broken;
  const scene::ReadIssues none;
  std::string refusal;
  const auto context = validate::build_context(scene, none, tolerance, refusal);
  if (!context) return broken;
  for (const validate::Rule* rule : validate::all_rules()) {
    if (rule->check == nullptr || !counts(*rule)) continue;
    validate::Violations violations;
    rule->check(*context, violations);
    if (const std::size_t count = sets_of_sources(scene, violations); count > 0) broken[rule->id] = count;
  }
  return broken;
}

std::vector<Rise> rises(const BrokenCounts& before, const BrokenCounts& after) {
  std::vector<Rise> found;
  for (const auto& [rule, count] : after) {
    const auto known = before.find(rule);
    const std::size_t allowed = known == before.end() ? 0 : known->second;
    if (count > allowed) found.push_back({rule, allowed, count});
  }
  return found;
}

}  // namespace rad::repair
