// The keys that the top of a file and its [[files]] entries have in common.
#pragma once

#include <span>

#include "config/keys.h"
#include "config/settings.h"

namespace rad::config {

std::span<const Key<Settings>> settings_keys();

/// Selectors of rules. Throws ConfigFault where one names no rule.
Words selectors_of(const Entry& entry);

/// A table of rules, each with a severity or a table of what is set of it: `rules = { RL240 = "note", RL212 = { max-gap
/// = 5 } }`.
std::map<const validate::Rule*, RuleSettings> rules_in(const Entry& entry);

}  // namespace rad::config
