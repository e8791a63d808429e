// The keys that the top of a file and its [[files]] entries have in common.
#pragma once

#include <span>

#include "config/keys.h"
#include "config/settings.h"

namespace rad::config {

std::span<const Key<Settings>> settings_keys();

/// Selectors of rules. Throws ConfigFault where one names no rule.
Words selectors_of(const Entry& entry);

/// A table of rules that holds nothing but severities: `rules = { RL240 = "note" }` of [[objects]].
std::map<const validate::Rule*, RuleSeverity> severities_of(const Entry& entry);

}  // namespace rad::config
