// The reports of a run of radlint, to files and to standard output.
#pragma once

#include <ostream>

#include "cli/options.h"
#include "cli/terminal.h"
#include "report/report.h"

namespace rad::cli {

/// Writes the reports that the command asks for. False, with a line on `err`, where one could not be written.
bool write_reports(const LintCommand& command, const report::Report& report, std::ostream& out, std::ostream& err,
                   const Terminal& terminal);

/// What the reports of the command show of findings.
report::Detail shown_detail(const LintCommand& command);

/// Whether a report of the command lists at most --max-issues findings of a rule.
bool any_limited(const LintCommand& command);

/// What stands in every report on a run of this command, but for what its configuration may say.
report::Report empty_report(const LintCommand& command);

/// Writes a report to standard output; a reader that has seen enough is no failure. False, with a line on `err`, where
/// it could not be written.
bool write_to_stdout(std::ostream& out, std::ostream& err, const std::string& text);

}  // namespace rad::cli
