#include "config/words.h"

#include "validate/registry.h"

namespace rad::config {

std::string unknown_rule_text(std::string_view selector) {
  return "no rule is called '" + std::string(selector) + "'" + did_you_mean(validate::nearest_selector(selector)) +
         " (radlint rules lists all)";
}

}  // namespace rad::config
