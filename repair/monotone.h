// The promise that repair makes nothing worse: for no rule more places in error than the input has.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geom/tolerance.h"
#include "scene/scene.h"
#include "validate/rule.h"

namespace rad::repair {

/// By rule id: how many sets of faces of the very first input break it. Faces count by where they came from, so that
/// cutting a face does not multiply what is wrong with it. Rules that are not broken are left out.
using BrokenCounts = std::map<std::string_view, std::size_t>;
BrokenCounts broken_counts(const scene::Scene& scene, const std::optional<geom::ToleranceRequest>& tolerance,
                           const std::function<bool(const validate::Rule&)>& counts);

/// Of the rules that are errors at stage model.
BrokenCounts error_counts(const scene::Scene& scene, const std::optional<geom::ToleranceRequest>& tolerance);

struct Rise {
  std::string_view rule;
  std::size_t before = 0;
  std::size_t after = 0;
};

/// Rules of which `after` has more, by id.
std::vector<Rise> rises(const BrokenCounts& before, const BrokenCounts& after);

}  // namespace rad::repair
