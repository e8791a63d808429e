// Declarations of all rules, from rules.def.
#pragma once

#include "validate/rule.h"

namespace rad::validate {

#define RAD_RULE(name) extern const Rule name;
#include "validate/rules.def"
#undef RAD_RULE

}  // namespace rad::validate
