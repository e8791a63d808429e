#include "cli/radlint.h"

#include <algorithm>

#include "cli/baseline.h"
#include "cli/diff_command.h"
#include "cli/exit_code.h"
#include "cli/lint_reports.h"
#include "cli/lint_run.h"
#include "cli/model_views.h"
#include "cli/offender_model.h"
#include "cli/options.h"
#include "cli/rule_pages.h"
#include "cli/saved_report.h"
#include "report/merge.h"

namespace rad::cli {

namespace {

bool any_incomplete(const report::Report& report) {
  return std::ranges::any_of(report.inputs,
                             [](const report::InputReport& input) { return !input.result.incomplete.empty(); });
}

int complain(std::ostream& err, const std::string& what, int exit_code = kUsage) {
  err << "radlint: " << what << '\n';
  return exit_code;
}

int conclude(const LintCommand& command, report::Report report, std::ostream& out, std::ostream& err,
             const Terminal& terminal) {
  if (const std::string problem = use_baseline(command, report); !problem.empty()) return complain(err, problem);
  if (!command.annotate.empty()) {
    if (const std::string problem = annotate(command, report); !problem.empty()) return complain(err, problem);
  }
  if (asks_for_html(command)) add_views(command, report);
  if (!write_reports(command, report, out, err, terminal)) return kUsage;
  if (any_incomplete(report)) return kIncomplete;
  return reaches(counts(report), report.fail_on) ? kFindings : kClean;
}

int run_lint(const LintCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  LintRun run = judge_paths(command, err, terminal);
  if (!run.problem.empty()) return complain(err, run.problem, run.exit_code);
  return conclude(command, std::move(run.report), out, err, terminal);
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
  return conclude(command.how, std::move(joined.report), out, err, terminal);
}

}  // namespace

int run_radlint(std::span<const std::string> args, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  const auto command = parse_radlint(args);
  if (const Stop* stop = std::get_if<Stop>(&command)) {
    out << stop->out << std::flush;
    err << stop->err;
    return stop->exit_code;
  }
  if (const RuleCommand* rule = std::get_if<RuleCommand>(&command)) {
    return run_rule_pages(*rule, out, err, terminal.columns);
  }
  if (const MergeCommand* merge = std::get_if<MergeCommand>(&command)) return run_merge(*merge, out, err, terminal);
  if (const DiffCommand* diff = std::get_if<DiffCommand>(&command)) return run_diff(*diff, out, err, terminal);
  return run_lint(std::get<LintCommand>(command), out, err, terminal);
}

}  // namespace rad::cli
