// The rule table of a SARIF run. Only .cpp files of this folder include it.
#pragma once

#include "report/json_parts.h"
#include "validate/rule.h"

namespace rad::report {

/// Descriptors of all rules, in the order of validate::all_rules(), with severities as at `stage`.
Json sarif_rules_json(validate::Stage stage);

}  // namespace rad::report
