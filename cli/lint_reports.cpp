#include "cli/lint_reports.h"

#include <cerrno>

#include "cli/report_file.h"
#include "report/html/page.h"
#include "report/json.h"
#include "report/leak_line.h"
#include "report/text.h"

namespace rad::cli {

namespace {

std::string rendered(const report::Report& report, Format format, const report::TextOptions& text, bool timings) {
  switch (format) {
    case Format::Json:
      return report::json(report, timings);
    case Format::Html:
      return report::html::page(report);
    case Format::LeakLine:
      return report::leak_lines(report);
    case Format::Text:
    case Format::Markdown:
      break;
  }
  return report::text(report, text);
}

}  // namespace

bool write_reports(const LintCommand& command, const report::Report& report, std::ostream& out, std::ostream& err,
                   const Terminal& terminal) {
  bool all = true;
  for (const FileReport& file : command.reports) {
    const report::TextOptions plain{false, 80, command.max_findings};
    const std::string problem = write_report_file(file.path, rendered(report, file.format, plain, command.timings));
    if (problem.empty()) continue;
    err << "radlint: " << problem << '\n';
    all = false;
  }
  if (command.quiet) return all;
  const report::TextOptions text{use_color(command.color, terminal), terminal.columns, command.max_findings};
  errno = 0;
  out << rendered(report, command.format, text, command.timings) << std::flush;
  // A reader that has seen enough closes the pipe: no failure of ours.
  if (out || errno == EPIPE) return all;
  err << "radlint: the report cannot be written to standard output\n";
  return false;
}

}  // namespace rad::cli
