#include "cli/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/report_file.h"
#include "cli/saved_report.h"
#include "report/baseline.h"
#include "report/text_layout.h"
#include "report/truncation.h"
#include "validate/grouping.h"
#include "validate/rules.h"
#include "validate/tool_finding.h"

namespace rad::cli {

namespace {

namespace fs = std::filesystem;

// Paths in a baseline are relative to the folder that it is in, so that it goes with the models.
std::string folder_of(const std::string& baseline) {
  std::error_code error;
  return fs::absolute(baseline, error).lexically_normal().parent_path().string();
}

report::Report with_absolute_paths(report::Report report) {
  std::error_code error;
  for (report::InputReport& input : report.inputs) {
    input.path = fs::absolute(input.path, error).lexically_normal().generic_string();
    for (scene::Finding& finding : input.result.findings) {
      finding.where.file = fs::absolute(finding.where.file, error).lexically_normal().generic_string();
    }
  }
  return report;
}

std::string write_baseline(const std::string& path, const report::Report& report) {
  return write_report_file(path, report::baseline_json(with_absolute_paths(report), folder_of(path)));
}

void add_stale(const LintCommand& command, const report::BaselineUse& use, scene::Severity severity,
               report::InputReport& input) {
  scene::Where where;
  where.file = command.baseline.path;
  const std::string what =
      fmt::format("{} of {} not there any more", report::counted(use.stale.size(), "finding"), input.path);
  scene::Finding finding = validate::tool_finding(validate::stale_baseline, what, where);
  finding.severity = command.baseline.strict ? scene::Severity::Error : severity;
  finding.baseline = scene::BaselineState::New;
  input.result.findings.push_back(std::move(finding));
  validate::sort_findings(input.result.findings);
}

}  // namespace

std::string baseline_fault(const BaselineChoice& choice) {
  if (!choice.path.empty() && !choice.write.empty()) return "--write-baseline makes a new one; leave --baseline out";
  if (choice.path.empty() && choice.prune) return "--prune-baseline: say which with --baseline";
  if (choice.path.empty() && choice.strict) return "--strict-baseline: say which with --baseline";
  return {};
}

std::string use_baseline(const LintCommand& command, report::Report& report,
                         const std::function<std::optional<scene::Severity>(const std::string&)>& stale_severity) {
  const BaselineChoice& choice = command.baseline;
  if (!choice.write.empty()) {
    if (std::string problem = write_baseline(choice.write, report); !problem.empty()) return problem;
    const report::Report all = report;
    report::apply_baseline(all, report);
    return {};
  }
  if (choice.path.empty()) return {};
  SavedReport baseline = read_saved_report(choice.path);
  if (!baseline.problem.empty()) return baseline.problem;
  report::forget_truncation(baseline.report);
  const auto uses = report::apply_baseline(baseline.report, report);
  if (choice.prune) {
    return write_report_file(choice.path, report::baseline_json(report::pruned(baseline.report, uses), {}));
  }
  for (const report::BaselineUse& use : uses) {
    report::InputReport& input = report.inputs[use.input];
    const auto severity = use.stale.empty() ? std::nullopt : stale_severity(input.path);
    if (severity) add_stale(command, use, *severity, input);
  }
  return {};
}

}  // namespace rad::cli
