// What is in force for one model: all that speaks of it, put on top of each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/chain.h"
#include "validate/lint.h"

namespace rad::config {

/// How a rule is checked, and who says so.
struct RuleInForce {
  const validate::Rule* rule = nullptr;
  bool on = true;
  Origin on_origin;
  std::optional<Stated<scene::Severity>> severity;          ///< nothing: that of the stage
  std::map<std::string_view, Stated<double>> parameters{};  ///< thresholds that differ from the standard ones
};

struct InForce {
  std::vector<RuleInForce> rules;  ///< all, in their order
  std::optional<Stated<double>> metres_per_unit;
  std::optional<Stated<scene::UpAxis>> up;
  std::optional<Stated<geom::ToleranceRequest>> tolerance;
  std::optional<Stated<double>> level_of_detail;
  std::vector<const ObjectsEntry*> objects;  ///< of the chain, which must live on
};

/// In this order, what comes later wins: for every file of the chain its top and then its [[files]] entries that fit
/// `model` (absolute, lexically normal); then the command line. `select` and `ignore` replace what was there, the lists
/// that extend add to it; what is selected later is no longer ignored. A severity "off" stands above both.
InForce in_force(const Chain& chain, const std::filesystem::path& model, const Settings& command_line);

/// The entries of [[files]] in the chain that fit the model, as one number each, for telling models apart that are
/// judged alike.
std::vector<std::size_t> fitting_files(const Chain& chain, const std::filesystem::path& model);

/// Whether models of one folder may be judged differently.
bool has_files_entries(const Chain& chain);

/// The last that is stated in the chain; nothing where none is.
std::optional<Stated<validate::Stage>> stage_of(const Chain& chain);
std::optional<Stated<report::FailOn>> fail_on_of(const Chain& chain);

/// Rules, severities, thresholds, tolerance, and the waivers of [[objects]] (scope Names).
validate::LintOptions lint_options(const InForce& in_force);

}  // namespace rad::config
