#include "cli/radlint.h"

#include <algorithm>
#include <memory>
#include <new>

#include "cli/exit_code.h"
#include "cli/inputs.h"
#include "cli/judge.h"
#include "cli/lint_reports.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/rule_pages.h"
#include "cli/threads.h"
#include "report/html/model_view.h"

namespace rad::cli {

namespace {

validate::LintOptions lint_options(const LintCommand& command) {
  validate::LintOptions options;
  options.stage = command.stage;
  options.rules = command.rules;
  options.tolerance = command.model.tolerance;
  options.group = command.group;
  return options;
}

report::Report empty_report(const LintCommand& command) {
  report::Report report;
  report.stage = command.stage;
  report.fail_on = command.fail_on;
  report.select = command.select;
  report.ignore = command.ignore;
  report.max_issues = command.max_issues;
  return report;
}

struct Judgement {
  report::Report report;
  std::string refusal;  ///< why the tolerance cannot be used; then the report is not complete
  bool short_of_memory = false;
};

bool asks_for(const LintCommand& command, Format format) {
  return command.format == format ||
         std::ranges::any_of(command.reports, [&](const FileReport& report) { return report.format == format; });
}

void add_view(const LintCommand& command, Model& model) {
  if (!asks_for(command, Format::Html) || !model.report.read) return;
  auto view = report::html::model_view(model.content.scene, model.report, command.max_issues);
  if (view) model.report.view = std::make_shared<const report::html::ModelView>(std::move(*view));
}

report::InputReport judge_file(const std::string& path, const LintCommand& command, bool& short_of_memory) {
  const validate::LintOptions options = lint_options(command);
  try {
    Model model = read_model(path, command.model);
    judge(model, options);
    add_view(command, model);
    return std::move(model.report);
  } catch (const std::bad_alloc&) {
    short_of_memory = true;
    return out_of_memory(path, options);
  }
}

Judgement judge_files(const std::vector<std::string>& paths, const LintCommand& command, Progress& progress) {
  Judgement judgement{empty_report(command), {}, false};
  for (std::size_t index = 0; index < paths.size(); ++index) {
    progress.show(index, paths[index]);
    report::InputReport input = judge_file(paths[index], command, judgement.short_of_memory);
    if (!input.result.refusal.empty()) {
      judgement.refusal = paths[index] + ": " + input.result.refusal;
      return judgement;
    }
    judgement.report.inputs.push_back(std::move(input));
  }
  return judgement;
}

bool any_incomplete(const report::Report& report) {
  return std::ranges::any_of(report.inputs,
                             [](const report::InputReport& input) { return !input.result.incomplete.empty(); });
}

int run_lint(const LintCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  const InputFiles files = collect_inputs(command.paths);
  if (!files.problem.empty()) {
    err << "radlint: " << files.problem << '\n';
    return kUsage;
  }
  const Threads threads(command.model.jobs);
  Judgement judgement;
  {
    Progress progress(err, terminal.err_is_terminal && !command.quiet, files.paths.size());
    judgement = judge_files(files.paths, command, progress);
  }
  if (!judgement.refusal.empty()) {
    err << "radlint: " << judgement.refusal << '\n';
    return kUsage;
  }
  if (!write_reports(command, judgement.report, out, err, terminal)) return kUsage;
  if (judgement.short_of_memory || any_incomplete(judgement.report)) return kIncomplete;
  return reaches(counts(judgement.report), command.fail_on) ? kFindings : kClean;
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
  return run_lint(std::get<LintCommand>(command), out, err, terminal);
}

}  // namespace rad::cli
