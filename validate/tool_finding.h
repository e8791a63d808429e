// Findings about the run and not about the model: RL901 to RL905.
#pragma once

#include <string_view>

#include "scene/finding.h"
#include "validate/rule.h"

namespace rad::validate {

/// A finding of a rule that is `of_tool`, at the severity of the rule. `detail`: one clause, lower case, no full stop.
/// `where` names what it is about: a file, and a line or an object where there is one.
scene::Finding tool_finding(const Rule& rule, std::string_view detail, scene::Where where);

}  // namespace rad::validate
