// Turning the words after options into values, with a sentence for the words that are none.
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace rad::cli {

/// Words as they stand on the command line; empty where the option was not given.
struct ModelWords {
  std::string tolerance;
  std::string units;
  std::string up;
  std::string jobs;
  std::string level_of_detail;
  bool allow_commands = false;
};

struct LintWords {
  std::string format;
  std::vector<std::string> reports;
  std::string stage;
  std::string fail_on;
  std::string max_issues;
  std::string max_findings;
  std::string color;
  std::string time_limit;
  std::string memory_limit;
  std::string shard;
  ModelWords model;
};

struct FixWords {
  std::string coplanar_policy;
  bool mesh = false;
  bool solve = false;
  std::string until;
  std::vector<std::string> only;
  std::vector<std::string> skip;
  std::vector<std::string> fix_only;
  std::vector<std::string> reports;
  std::string patch_size;
  std::vector<std::string> patch_sizes;
  std::string pmesh;
  std::string emesh;
  std::string shadow_size;
  std::string preview_mesh;
  std::string camera;
  std::string element_size;
  std::string exposure;
  std::string curve;
  bool false_colour = false;
  std::string bake;
  std::string texel;
  std::string page_size;
  std::string store;
};

/// Each returns a sentence on the first word that is wrong, empty where all were right.
std::string read_model_words(const ModelWords& words, ModelOptions& into);
std::string read_lint_words(const LintWords& words, LintCommand& into);
std::string read_diff_words(const LintWords& words, DiffCommand& into);
std::string read_rule_format(const std::string& word, PageFormat& into);
std::string read_fix_words(const FixWords& words, FixCommand& into);
/// Of `radlint config`.
std::string read_config_format(const std::string& word, PageFormat& into);
/// Fills LintCommand::settings from the other members.
std::string read_settings(LintCommand& command);

}  // namespace rad::cli
