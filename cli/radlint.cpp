#include "cli/radlint.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/exit_code.h"
#include "cli/inputs.h"
#include "cli/judge_files.h"
#include "cli/lint_reports.h"
#include "cli/live_line.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/rule_pages.h"
#include "config/path_glob.h"
#include "readers/file_bytes.h"
#include "report/merge.h"
#include "report/read_report.h"

namespace rad::cli {

namespace {

constexpr std::uint64_t kLargestReport = std::uint64_t{4} << 30;

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

config::PathPattern below_here(const std::string& glob) { return {glob, std::filesystem::current_path()}; }

InputFiles inputs_of(const LintCommand& command) {
  std::vector<config::PathPattern> excluded;
  for (const std::string& glob : command.exclude) excluded.push_back(below_here(glob));
  return collect_inputs(command.paths, [&](const std::filesystem::path& path) {
    return std::ranges::any_of(excluded, [&](const config::PathPattern& pattern) { return pattern.covers(path); });
  });
}

/// Keeps the files of the shard; says which they are of all.
std::optional<report::Shard> take_shard(const std::optional<ShardChoice>& choice, std::vector<std::string>& paths) {
  if (!choice) return std::nullopt;
  report::Shard shard{choice->index, choice->count, paths.size(), positions_in_shard(paths, *choice)};
  std::vector<std::string> mine;
  for (const std::size_t position : shard.positions) mine.push_back(std::move(paths[position]));
  paths = std::move(mine);
  return shard;
}

// Where one file is judged again and again it is being worked on: kept results would only pile up.
std::optional<std::filesystem::path> cache_of(const LintCommand& command, std::size_t files, const Terminal& terminal) {
  if (command.no_cache || command.timings) return std::nullopt;
  if (!command.cache.empty()) return command.cache;
  if (files < 2 || terminal.cache_home.empty()) return std::nullopt;
  return std::filesystem::path(terminal.cache_home) / "radlint";
}

RunPlan plan_of(const LintCommand& command, const std::vector<std::string>& paths, const Terminal& terminal) {
  RunPlan plan;
  for (const std::string& path : paths) plan.files.push_back({path, command.model, lint_options(command)});
  plan.jobs = command.model.jobs;
  plan.limits = command.limits;
  plan.cache = cache_of(command, paths.size(), terminal);
  plan.workers = terminal.alone;
  return plan;
}

JudgedFiles judge_with_progress(const RunPlan& plan, const LintCommand& command, std::ostream& err,
                                const Terminal& terminal) {
  Progress progress(err, terminal.err_is_terminal && !command.quiet, terminal.err_columns, plan.files.size());
  const std::optional<InterruptWatch> watch = plan.workers ? std::make_optional<InterruptWatch>() : std::nullopt;
  return judge_files(
      plan, [&](std::size_t done, const std::string& path) { progress.show(done, path); },
      [&] { return watch && watch->interrupted(); });
}

/// The first file whose tolerance cannot be used, and why; empty where there is none.
std::string first_refusal(const report::Report& report) {
  for (const report::InputReport& input : report.inputs) {
    if (!input.result.refusal.empty()) return input.path + ": " + input.result.refusal;
  }
  return {};
}

bool any_incomplete(const report::Report& report) {
  return std::ranges::any_of(report.inputs,
                             [](const report::InputReport& input) { return !input.result.incomplete.empty(); });
}

int conclude(const LintCommand& command, const report::Report& report, std::ostream& out, std::ostream& err,
             const Terminal& terminal) {
  if (!write_reports(command, report, out, err, terminal)) return kUsage;
  if (any_incomplete(report)) return kIncomplete;
  return reaches(counts(report), report.fail_on) ? kFindings : kClean;
}

int complain(std::ostream& err, const std::string& what, int exit_code = kUsage) {
  err << "radlint: " << what << '\n';
  return exit_code;
}

int run_lint(const LintCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  InputFiles files = inputs_of(command);
  if (!files.problem.empty()) return complain(err, files.problem);
  report::Report report = empty_report(command);
  report.shard = take_shard(command.shard, files.paths);
  JudgedFiles judged = judge_with_progress(plan_of(command, files.paths, terminal), command, err, terminal);
  if (judged.stopped) return complain(err, "interrupted; no report was written", kIncomplete);
  report.inputs = std::move(judged.inputs);
  if (const std::string refusal = first_refusal(report); !refusal.empty()) return complain(err, refusal);
  return conclude(command, report, out, err, terminal);
}

int run_merge(const MergeCommand& command, std::ostream& out, std::ostream& err, const Terminal& terminal) {
  std::vector<report::Report> reports;
  for (const std::string& path : command.how.paths) {
    readers::FileBytes file;
    const std::string problem = file.open(path, kLargestReport, readers::FileKind::RegularOrStream);
    if (!problem.empty()) return complain(err, path + ": the report cannot be read: " + problem);
    report::ReadBack back = report::read_report(file.bytes());
    if (!back.problem.empty()) return complain(err, path + ": the report cannot be read: " + back.problem);
    reports.push_back(std::move(back.report));
  }
  report::Joined joined = report::merged(std::move(reports));
  if (!joined.problem.empty()) return complain(err, "the reports cannot be merged: " + joined.problem);
  return conclude(command.how, joined.report, out, err, terminal);
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
  return run_lint(std::get<LintCommand>(command), out, err, terminal);
}

}  // namespace rad::cli
