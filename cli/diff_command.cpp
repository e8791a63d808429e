#include "cli/diff_command.h"

#include "cli/exit_code.h"
#include "cli/lint_reports.h"
#include "cli/lint_run.h"
#include "cli/model_views.h"
#include "cli/report_choice.h"
#include "cli/report_file.h"
#include "cli/saved_report.h"
#include "report/diff_report.h"
#include "report/truncation.h"

namespace rad::cli {

namespace {

/// One side of the comparison.
LintRun side_of(const std::string& path, const LintCommand& lint, std::ostream& err, const Terminal& terminal) {
  if (names_report(path)) {
    SavedReport saved = read_saved_report(path);
    report::forget_truncation(saved.report);
    if (lint.fail_on) saved.report.fail_on = *lint.fail_on;
    return {std::move(saved.report), std::move(saved.problem), kUsage};
  }
  LintCommand of_path = lint;
  of_path.paths = {path};
  RunSettings settings(of_path);
  return judge_paths(of_path, settings, report::Detail::Drawings, err, terminal);
}

bool write_diff(const DiffCommand& command, const report::Diff& diff, std::ostream& out, std::ostream& err,
                const Terminal& terminal) {
  bool all = true;
  report::WriteOptions options = file_write_options();
  options.text.max_findings = command.lint.max_findings;
  for (const DiffFileReport& file : command.reports) {
    const std::string problem = write_report_file(file.path, file.format->write(diff, options));
    if (problem.empty()) continue;
    err << "radlint: " << problem << '\n';
    all = false;
  }
  if (command.lint.quiet) return all;
  options.text.color = use_color(command.lint.color, terminal);
  options.text.width = terminal.columns;
  return write_to_stdout(out, err, command.format->write(diff, options)) && all;
}

}  // namespace

int run_diff(const DiffCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  LintRun old = side_of(command.old, command.lint, err, terminal);
  LintRun now = old.problem.empty() ? side_of(command.now, command.lint, err, terminal) : LintRun{};
  for (const LintRun* side : {&old, &now}) {
    if (side->problem.empty()) continue;
    err << "radlint: " << side->problem << '\n';
    return side->exit_code;
  }
  if (asks_for_html(command)) {
    RunSettings settings(command.lint);
    for (LintRun* side : {&old, &now}) add_views(command.lint, settings, side->report);
  }
  const report::Diff diff = report::diff_of(old.report, now.report);
  if (!write_diff(command, diff, out, err, terminal)) return kUsage;
  if (report::fails(diff)) return kFindings;
  return report::gaps(diff).empty() ? kClean : kIncomplete;
}

}  // namespace rad::cli
