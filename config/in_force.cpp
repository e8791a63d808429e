#include "config/in_force.h"

#include <algorithm>
#include <stdexcept>

#include "validate/registry.h"

namespace rad::config {

namespace {

/// Which rules are chosen, and by whom.
class RuleChoice {
 public:
  RuleChoice() {
    for (const validate::Rule* rule : validate::all_rules()) selected_[rule] = {};
  }

  void apply(const Settings& settings) {
    if (settings.select) {
      selected_.clear();
      add_selected(*settings.select);
    }
    if (settings.extend_select) add_selected(*settings.extend_select);
    if (settings.ignore) {
      ignored_.clear();
      add_ignored(*settings.ignore);
    }
    if (settings.extend_ignore) add_ignored(*settings.extend_ignore);
    if (settings.select) narrowed_by_ = settings.select->origin;
    for (const auto& [rule, given] : settings.rules) {
      if (given.severity) set_severity(rule, *given.severity);
      for (const auto& [name, value] : given.parameters) parameters_[rule].insert_or_assign(name, value);
    }
  }

  [[nodiscard]] std::vector<RuleInForce> rules() const {
    std::vector<RuleInForce> rules;
    for (const validate::Rule* rule : validate::all_rules()) rules.push_back(standing_of(rule));
    return rules;
  }

 private:
  void add_selected(const Stated<Words>& words) {
    for_each_rule(words, [&](const validate::Rule* rule) {
      selected_[rule] = words.origin;
      ignored_.erase(rule);
    });
  }

  void add_ignored(const Stated<Words>& words) {
    for_each_rule(words, [&](const validate::Rule* rule) { ignored_[rule] = words.origin; });
  }

  void set_severity(const validate::Rule* rule, const Stated<RuleSeverity>& severity) {
    off_.erase(rule);
    severities_.erase(rule);
    if (severity.value) {
      severities_[rule] = {*severity.value, severity.origin};
    } else {
      off_[rule] = severity.origin;
    }
  }

  template <typename Use>
  static void for_each_rule(const Stated<Words>& words, Use use) {
    for (const std::string& selector : words.value) std::ranges::for_each(validate::matching_rules(selector), use);
  }

  [[nodiscard]] RuleInForce standing_of(const validate::Rule* rule) const {
    RuleInForce standing{rule, true, {}, std::nullopt, {}};
    const auto say = [&](const std::map<const validate::Rule*, Origin>& from, bool on) {
      const auto found = from.find(rule);
      if (found != from.end()) standing.on = on, standing.on_origin = found->second;
      return found != from.end();
    };
    if (!say(off_, false) && !say(ignored_, false) && !say(selected_, true)) {
      standing.on = false;
      standing.on_origin = narrowed_by_;
    }
    if (const auto found = severities_.find(rule); found != severities_.end()) standing.severity = found->second;
    if (const auto found = parameters_.find(rule); found != parameters_.end()) standing.parameters = found->second;
    return standing;
  }

  std::map<const validate::Rule*, Origin> selected_, ignored_, off_;
  std::map<const validate::Rule*, Stated<scene::Severity>> severities_;
  std::map<const validate::Rule*, std::map<std::string_view, Stated<double>>> parameters_;
  Origin narrowed_by_;  ///< of the last `select`
};

class Layers {
 public:
  void apply(const Settings& settings) {
    choice_.apply(settings);
    replace(settings.metres_per_unit, result_.metres_per_unit);
    replace(settings.up, result_.up);
    replace(settings.tolerance, result_.tolerance);
    replace(settings.level_of_detail, result_.level_of_detail);
  }

  void apply(const ConfigFile& file, const std::filesystem::path& model) {
    apply(file.settings);
    for (const FilesEntry& entry : file.files) {
      if (entry.fits(model)) apply(entry.settings);
    }
    for (const ObjectsEntry& entry : file.objects) result_.objects.push_back(&entry);
  }

  InForce take() {
    result_.rules = choice_.rules();
    return std::move(result_);
  }

 private:
  template <typename T>
  static void replace(const std::optional<T>& by, std::optional<T>& what) {
    if (by) what = by;
  }

  RuleChoice choice_;
  InForce result_;
};

scene::Waiver waiver_of(const ObjectsEntry& entry) {
  scene::Waiver waiver;
  waiver.rules = entry.ignore;
  waiver.reason = entry.reason;
  waiver.place.file = entry.origin.source;
  waiver.place.line = entry.origin.line;
  waiver.scope = scene::WaiverScope::Names;
  waiver.names = entry.names;
  waiver.origin = scene::WaiverOrigin::Configuration;
  return waiver;
}

void add_objects(const InForce& in_force, validate::LintOptions& options) {
  for (const ObjectsEntry* entry : in_force.objects) {
    if (!entry->ignore.empty()) options.waivers.push_back(waiver_of(*entry));
    for (const auto& [rule, severity] : entry->severities) {
      options.named_severities.push_back({entry->names, rule, severity});
    }
    for (const auto& [rule, values] : entry->thresholds) {
      for (const auto& [name, value] : values) options.named_thresholds.push_back({entry->names, rule, name, value});
    }
  }
}

template <typename T, typename Member>
std::optional<Stated<T>> last_of(const Chain& chain, Member member) {
  for (auto file = chain.rbegin(); file != chain.rend(); ++file) {
    if ((**file).*member) return (**file).*member;
  }
  return std::nullopt;
}

}  // namespace

InForce in_force(const Chain& chain, const std::filesystem::path& model, const Settings& command_line) {
  Layers layers;
  for (const auto& file : chain) layers.apply(*file, model);
  layers.apply(command_line);
  return layers.take();
}

std::vector<std::size_t> fitting_files(const Chain& chain, const std::filesystem::path& model) {
  std::vector<std::size_t> numbers;
  std::size_t number = 0;
  for (const auto& file : chain) {
    for (const FilesEntry& entry : file->files) {
      if (entry.fits(model)) numbers.push_back(number);
      ++number;
    }
  }
  return numbers;
}

bool has_files_entries(const Chain& chain) {
  return std::ranges::any_of(chain, [](const auto& file) { return !file->files.empty(); });
}

std::optional<Stated<validate::Stage>> stage_of(const Chain& chain) {
  return last_of<validate::Stage>(chain, &ConfigFile::stage);
}

std::optional<Stated<report::FailOn>> fail_on_of(const Chain& chain) {
  return last_of<report::FailOn>(chain, &ConfigFile::fail_on);
}

validate::LintOptions lint_options(const InForce& in_force) {
  validate::LintOptions options;
  options.rules.clear();
  for (const RuleInForce& it : in_force.rules) {
    if (it.on) options.rules.push_back(it.rule);
    if (it.severity) options.severities[it.rule] = it.severity->value;
    for (const auto& [name, value] : it.parameters) {
      if (const std::string fault = options.parameters.set(*it.rule, name, value.value); !fault.empty()) {
        throw std::logic_error(fault);  // refused when it was read
      }
    }
  }
  if (in_force.tolerance) options.tolerance = in_force.tolerance->value;
  add_objects(in_force, options);
  return options;
}

}  // namespace rad::config
