#include "cli/lint_run.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/exit_code.h"
#include "cli/inputs.h"
#include "cli/judge_files.h"
#include "cli/lint_reports.h"
#include "cli/live_line.h"
#include "cli/progress.h"

namespace rad::cli {

namespace {

/// Keeps the files of the shard; says which they are of all.
std::optional<report::Shard> take_shard(const std::optional<ShardChoice>& choice, std::vector<FilePlan>& files) {
  if (!choice) return std::nullopt;
  std::vector<std::string> paths;
  for (const FilePlan& file : files) paths.push_back(file.path);
  report::Shard shard{choice->index, choice->count, paths.size(), positions_in_shard(paths, *choice)};
  std::vector<FilePlan> mine;
  for (const std::size_t position : shard.positions) mine.push_back(std::move(files[position]));
  files = std::move(mine);
  return shard;
}

// Where one file is judged again and again it is being worked on: kept results would only pile up.
std::optional<std::filesystem::path> cache_of(const LintCommand& command, std::size_t files, const Terminal& terminal) {
  if (command.no_cache || command.timings) return std::nullopt;
  if (!command.cache.empty()) return command.cache;
  if (files < 2 || terminal.cache_home.empty()) return std::nullopt;
  return std::filesystem::path(terminal.cache_home) / "radlint";
}

RunPlan plan_of(const LintCommand& command, std::vector<FilePlan> files, const Terminal& terminal) {
  RunPlan plan;
  plan.files = std::move(files);
  plan.jobs = command.model.jobs;
  plan.limits = command.limits;
  plan.cache = cache_of(command, plan.files.size(), terminal);
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

}  // namespace

LintRun judge_paths(const LintCommand& command, RunSettings& settings, report::Detail detail, std::ostream& err,
                    const Terminal& terminal) {
  InputFiles files =
      collect_inputs(command.paths, [&](const std::filesystem::path& path) { return settings.excludes(path); });
  if (!files.problem.empty()) return {{}, files.problem, kUsage};
  std::vector<FilePlan> plans = settings.plans_of(files.paths);
  LintRun run{empty_report(command), {}, kClean};
  run.report.stage = settings.stage().value;
  run.report.fail_on = settings.fail_on().value;
  run.report.shard = take_shard(command.shard, plans);
  RunPlan plan = plan_of(command, std::move(plans), terminal);
  plan.detail = detail;
  JudgedFiles judged = judge_with_progress(plan, command, err, terminal);
  if (judged.stopped) return {{}, "interrupted; no report was written", kIncomplete};
  run.report.inputs = std::move(judged.inputs);
  if (std::string refusal = first_refusal(run.report); !refusal.empty()) return {{}, std::move(refusal), kUsage};
  return run;
}

}  // namespace rad::cli
