// Pictures of the example models of a rule, made by the project's own renderer.
#pragma once

#include <filesystem>
#include <string>

#include "validate/rule.h"

namespace rad::tools {

/// PNG files; both empty where the fault is not one of shape, so that there is nothing to see.
struct RulePictures {
  std::string fail;  ///< the model that breaks the rule, the fault drawn over it
  std::string pass;  ///< its nearest good neighbour, from the same place
};

/// `folder` has one model named fail and one named pass.
RulePictures rule_pictures(const validate::Rule& rule, const std::filesystem::path& folder);

/// Whether two PNG files show the same, but for the last bits that another processor rounds otherwise.
bool shows_the_same(const std::string& png, const std::string& other);

}  // namespace rad::tools
