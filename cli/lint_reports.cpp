#include "cli/lint_reports.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>

#include "cli/report_choice.h"
#include "cli/report_file.h"
#include "report/markdown.h"

namespace rad::cli {

namespace {

constexpr std::size_t kSummaryLimit = 900'000;  // bytes; GitHub: 1 MiB for the summary of a step

// The page of a step takes Markdown beside the annotations.
void append_step_summary(const report::Report& report) {
  const char* const path = std::getenv("GITHUB_STEP_SUMMARY");
  if (path == nullptr) return;
  std::ofstream(path, std::ios::binary | std::ios::app) << report::markdown(report, kSummaryLimit);
}

}  // namespace

report::Detail shown_detail(const LintCommand& command) {
  if (!command.annotate.empty()) return report::Detail::Drawings;
  report::Detail detail = command.quiet ? report::Detail::Findings : command.format->shows;
  for (const FileReport& file : command.reports) detail = std::max(detail, file.format->shows);
  return detail;
}

bool any_limited(const LintCommand& command) {
  return (!command.quiet && command.format->is_limited) ||
         std::ranges::any_of(command.reports, [](const FileReport& file) { return file.format->is_limited; });
}

report::Report empty_report(const LintCommand& command) {
  report::Report report;
  report.select = command.select;
  report.ignore = command.ignore;
  report.max_issues = command.max_issues;
  return report;
}

bool write_to_stdout(std::ostream& out, std::ostream& err, const std::string& text) {
  errno = 0;
  out << text << std::flush;
  // A reader that has seen enough closes the pipe: no failure of ours.
  if (out || errno == EPIPE) return true;
  err << "radlint: the report cannot be written to standard output\n";
  return false;
}

bool write_reports(const LintCommand& command, const report::Report& report, std::ostream& out, std::ostream& err,
                   const Terminal& terminal) {
  bool all = true;
  report::WriteOptions options = file_write_options();
  options.text.max_findings = command.max_findings;
  options.timings = command.timings;
  for (const FileReport& file : command.reports) {
    const std::string problem = write_report_file(file.path, file.format->write(report, options));
    if (problem.empty()) continue;
    err << "radlint: " << problem << '\n';
    all = false;
  }
  if (command.quiet) return all;
  if (command.format->name == "github") append_step_summary(report);
  options.text.color = use_color(command.color, terminal);
  options.text.width = terminal.columns;
  return write_to_stdout(out, err, command.format->write(report, options)) && all;
}

}  // namespace rad::cli
