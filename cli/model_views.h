// Models as an HTML report shows them.
#pragma once

#include "cli/options.h"
#include "cli/run_settings.h"
#include "report/report.h"

namespace rad::cli {

/// Gives every input of the report its view. Models are read again one by one: results come from other processes, from
/// the cache or from a report. A model that is gone, or another by now, has no view.
void add_views(const LintCommand& command, RunSettings& settings, report::Report& report);

/// Whether a report of the command is HTML.
bool asks_for_html(const LintCommand& command);
bool asks_for_html(const DiffCommand& command);

}  // namespace rad::cli
