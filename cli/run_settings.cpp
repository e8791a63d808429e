#include "cli/run_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/fault.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

fs::path whole_path(const std::string& path) { return fs::absolute(path).lexically_normal(); }

std::string disagreement(std::string_view what, std::string_view here, const std::string& here_from,
                         const std::string& first, std::string_view there, const std::string& there_from) {
  return fmt::format("its {0} is {1} ({2}), and that of {3} is {4} ({5}): a run has one, to be named with --{0}", what,
                     here, here_from, first, there, there_from);
}

}  // namespace

RunSettings::RunSettings(const LintCommand& command) : command_(command), search_(command.config, command.isolated) {
  if (command.stage) stage_ = {*command.stage, {"--stage"}};
  if (command.fail_on) fail_on_ = {*command.fail_on, {"--fail-on"}};
  for (const std::string& glob : command.exclude) excluded_.push_back({glob, fs::current_path()});
}

config::Stated<validate::Stage> RunSettings::stage_in(const config::Chain& chain) const {
  if (command_.stage) return {*command_.stage, {"--stage"}};
  return config::stage_of(chain).value_or(config::Stated<validate::Stage>{validate::Stage::Model});
}

config::Stated<report::FailOn> RunSettings::fail_on_in(const config::Chain& chain) const {
  if (command_.fail_on) return {*command_.fail_on, {"--fail-on"}};
  return config::fail_on_of(chain).value_or(config::Stated<report::FailOn>{report::FailOn::Error});
}

const config::Chain& RunSettings::chain_of(const std::string& path) {
  std::error_code error;
  const fs::path whole = whole_path(path);
  return search_.of_folder(fs::is_directory(whole, error) ? whole : whole.parent_path());
}

config::InForce RunSettings::in_force(const std::string& path) {
  return config::in_force(chain_of(path), whole_path(path), command_.settings);
}

std::shared_ptr<const FileSettings> RunSettings::make(const config::Chain& chain, const fs::path& model) const {
  const config::InForce in_force = config::in_force(chain, model, command_.settings);
  auto settings = std::make_shared<FileSettings>();
  settings->model = command_.model;
  if (in_force.metres_per_unit) settings->model.metres_per_unit = in_force.metres_per_unit->value;
  if (in_force.up) settings->model.up = in_force.up->value;
  if (in_force.tolerance) settings->model.tolerance = in_force.tolerance->value;
  if (in_force.level_of_detail) settings->model.reading.level_of_detail = in_force.level_of_detail->value;
  settings->lint = config::lint_options(in_force);
  settings->lint.group = command_.group;
  settings->lint.stage = stage_in(chain).value;
  if (!chain.empty()) settings->configuration = chain.back()->shown;
  settings->digest = batch::digest128_of(settings_text(*settings));
  return settings;
}

std::shared_ptr<const FileSettings> RunSettings::of(const std::string& path) {
  const fs::path whole = whole_path(path);
  const config::Chain& chain = search_.of_folder(whole.parent_path());
  auto& made = made_[{&chain, config::fitting_files(chain, whole)}];
  if (!made) made = make(chain, whole);
  if (made->lint.rules.empty()) throw config::ConfigFault(path, 0, "no rule is left to check");
  return made;
}

void RunSettings::agree(const std::string& path, const std::string& first) {
  const config::Chain& chain = search_.of_folder(whole_path(path).parent_path());
  const auto stage = stage_in(chain);
  const auto fail_on = fail_on_in(chain);
  if (path == first) {
    stage_ = stage;
    fail_on_ = fail_on;
  }
  if (stage.value != stage_.value) {
    throw config::ConfigFault(path, 0,
                              disagreement("stage", validate::name(stage.value), stage.origin.text(), first,
                                           validate::name(stage_.value), stage_.origin.text()));
  }
  if (fail_on.value != fail_on_.value) {
    throw config::ConfigFault(path, 0,
                              disagreement("fail-on", report::name(fail_on.value), fail_on.origin.text(), first,
                                           report::name(fail_on_.value), fail_on_.origin.text()));
  }
}

std::vector<FilePlan> RunSettings::plans_of(const std::vector<std::string>& paths) {
  std::vector<FilePlan> plans;
  std::string_view folder;
  bool shared = false;  // whether all models of this folder are judged alike
  for (const std::string& path : paths) {
    const std::string_view its_folder = std::string_view(path).substr(0, path.rfind('/') + 1);
    if (shared && its_folder == folder) {
      plans.push_back({path, plans.back().settings});
      continue;
    }
    plans.push_back({path, of(path)});
    agree(path, paths.front());
    folder = its_folder;
    shared = !config::has_files_entries(search_.of_folder(whole_path(path).parent_path()));
  }
  return plans;
}

bool RunSettings::excludes(const fs::path& path) {
  const auto covers = [&](const config::PathPattern& pattern) { return pattern.covers(path); };
  return std::ranges::any_of(excluded_, covers) || config::excludes(search_.of_folder(path.parent_path()), path);
}

}  // namespace rad::cli
