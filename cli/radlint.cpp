#include "cli/radlint.h"

#include <algorithm>

#include "cli/baseline.h"
#include "cli/config_command.h"
#include "cli/diff_command.h"
#include "cli/exit_code.h"
#include "cli/lint_reports.h"
#include "cli/lint_run.h"
#include "cli/model_views.h"
#include "cli/offender_model.h"
#include "cli/options.h"
#include "cli/rule_pages.h"
#include "cli/saved_report.h"
#include "config/fault.h"
#include "report/merge.h"
#include "report/truncation.h"
#include "validate/rules.h"

namespace rad::cli {

namespace {

using Command = std::variant<LintCommand, RuleCommand, DiffCommand, MergeCommand, ConfigCommand, Stop>;

bool any_incomplete(const report::Report& report) {
  return std::ranges::any_of(report.inputs,
                             [](const report::InputReport& input) { return !input.result.incomplete.empty(); });
}

int complain(std::ostream& err, const std::string& what, int exit_code = kUsage) {
  err << "radlint: " << what << '\n';
  return exit_code;
}

/// What a rule about the run weighs for a model of it; nothing where it is not asked for.
std::optional<scene::Severity> severity_of(const validate::Rule& rule, const validate::LintOptions& options) {
  if (std::ranges::find(options.rules, &rule) == options.rules.end()) return std::nullopt;
  return validate::severity_of_tool_rule(rule, options);
}

// Reports that were read back may leave out what is here only counted.
void note_short_lists(const LintCommand& command, RunSettings& settings, report::Report& report) {
  const std::size_t max_issues = any_limited(command) ? report.max_issues : 0;
  for (report::InputReport& input : report.inputs) {
    if (report::unlisted_findings(input, max_issues).empty()) continue;
    const auto severity = severity_of(validate::truncated, settings.of(input.path)->lint);
    if (severity) report::note_truncation(input, max_issues, *severity);
  }
}

// To take the findings of many files apart takes a fifth of a run that finds all of them in the cache. The process
// ends: the system takes its memory back at once.
void leave_to_the_system(report::Report report) {
  [[maybe_unused]] static const report::Report* left = nullptr;
  left = new report::Report(std::move(report));
}

int conclude(const LintCommand& command, RunSettings& settings, report::Report report, std::ostream& out,
             std::ostream& err, const Terminal& terminal) {
  const std::string fault = use_baseline(command, report, [&](const std::string& path) {
    return severity_of(validate::stale_baseline, settings.of(path)->lint);
  });
  if (!fault.empty()) return complain(err, fault);
  note_short_lists(command, settings, report);
  if (!command.annotate.empty()) {
    if (const std::string problem = annotate(command, settings, report); !problem.empty())
      return complain(err, problem);
  }
  if (asks_for_html(command)) add_views(command, settings, report);
  if (!write_reports(command, report, out, err, terminal)) return kUsage;
  const int exit_code = any_incomplete(report)                    ? kIncomplete
                        : reaches(counts(report), report.fail_on) ? kFindings
                                                                  : kClean;
  if (terminal.alone) leave_to_the_system(std::move(report));
  return exit_code;
}

int run_lint(const LintCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  RunSettings settings(command);
  LintRun run = judge_paths(command, settings, shown_detail(command), err, terminal);
  if (!run.problem.empty()) return complain(err, run.problem, run.exit_code);
  return conclude(command, settings, std::move(run.report), out, err, terminal);
}

int run_merge(const MergeCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  std::vector<report::Report> reports;
  for (const std::string& path : command.how.paths) {
    SavedReport saved = read_saved_report(path);
    if (!saved.problem.empty()) return complain(err, saved.problem);
    reports.push_back(std::move(saved.report));
  }
  report::Joined joined = report::merged(std::move(reports));
  if (!joined.problem.empty()) return complain(err, "the reports cannot be merged: " + joined.problem);
  RunSettings settings(command.how);
  return conclude(command.how, settings, std::move(joined.report), out, err, terminal);
}

int run(const Command& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  if (const auto* rule = std::get_if<RuleCommand>(&command)) return run_rule_pages(*rule, out, err, terminal.columns);
  if (const auto* merge = std::get_if<MergeCommand>(&command)) return run_merge(*merge, out, err, terminal);
  if (const auto* diff = std::get_if<DiffCommand>(&command)) return run_diff(*diff, out, err, terminal);
  if (const auto* config = std::get_if<ConfigCommand>(&command)) return run_config(*config, out, err);
  return run_lint(std::get<LintCommand>(command), out, err, terminal);
}

}  // namespace

int run_radlint(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  const Command command = parse_radlint(args);
  if (const Stop* stop = std::get_if<Stop>(&command)) {
    out << stop->out << std::flush;
    err << stop->err;
    return stop->exit_code;
  }
  try {
    return run(command, out, err, terminal);
  } catch (const config::ConfigFault& fault) {
    return complain(err, fault.what());
  }
}

}  // namespace rad::cli
