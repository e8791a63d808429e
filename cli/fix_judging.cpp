#include "cli/fix_judging.h"

#include <algorithm>
#include <array>

#include "cli/file_plan.h"
#include "cli/run_settings.h"
#include "config/sidecar.h"
#include "validate/rules.h"

namespace rad::cli {

namespace {

void choose_rules(validate::LintOptions& options, const validate::Rule& added) {
  const std::vector<const validate::Rule*> chosen = std::move(options.rules);
  options.rules.clear();
  for (const validate::Rule* rule : validate::all_rules()) {
    if (rule == &added || std::ranges::find(chosen, rule) != chosen.end()) options.rules.push_back(rule);
  }
}

/// Whether findings are those of a run without configuration and suppressions.
bool is_plain(const Model& model, const validate::LintOptions& options) {
  validate::LintOptions plain;
  plain.tolerance = options.tolerance;
  return model.content.waivers.empty() && config::read_sidecar(config::sidecar_path(model.report.path)).empty() &&
         settings_text({{}, options, {}, {}}) == settings_text({{}, plain, {}, {}});
}

bool holds_for_the_result(const scene::Waiver& waiver) {
  return waiver.fault.empty() &&
         (waiver.scope == scene::WaiverScope::File || waiver.scope == scene::WaiverScope::Names);
}

}  // namespace

FixJudging configure(FixCommand& command) {
  RunSettings settings(command.judging);
  const std::shared_ptr<const FileSettings> in_force = settings.of(command.input);
  const std::size_t jobs = command.model.jobs;
  command.model = in_force->model;
  command.model.jobs = jobs;
  FixJudging judging{in_force->lint, in_force->configuration};
  judging.options.stage = validate::Stage::Model;
  choose_rules(judging.options, validate::thin_feature);
  return judging;
}

validate::LintResult judge_input(Model& model, const FixJudging& judging) {
  const bool plain = is_plain(model, judging.options);
  model.report.configuration = judging.configuration;
  judge_with_waivers(model, judging.options);
  if (plain) return model.report.result;
  validate::LintOptions options;
  options.tolerance = judging.options.tolerance;
  return validate::lint(model.content.scene, model.content.issues, options);
}

FixJudging judging_of_result(const Model& input, FixJudging judging) {
  std::vector<scene::Waiver> waivers = input.content.waivers;
  std::ranges::move(config::read_sidecar(config::sidecar_path(input.report.path)), std::back_inserter(waivers));
  std::erase_if(waivers, [](const scene::Waiver& waiver) { return !holds_for_the_result(waiver); });
  validate::LintOptions& options = judging.options;
  std::ranges::move(options.waivers, std::back_inserter(waivers));
  options.waivers = std::move(waivers);
  constexpr std::array kOfSuppressions = {&validate::unused_suppression, &validate::unknown_rule};
  std::erase_if(options.rules, [&](const validate::Rule* rule) {
    return std::ranges::find(kOfSuppressions, rule) != kOfSuppressions.end();
  });
  return judging;
}

void judge_result(Model& model, const FixJudging& judging) {
  model.report.configuration = judging.configuration;
  judge_with_waivers(model, judging.options);
}

}  // namespace rad::cli
