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

}  // namespace rad::cli
