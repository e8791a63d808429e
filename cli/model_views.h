// Models as an HTML report shows them.
#pragma once

#include "cli/options.h"
#include "report/report.h"

namespace rad::cli {

/// Gives every input of the report its view, where the command asks for HTML. Models are read again one by one: results
/// come from other processes, from the cache or from a report. A model that is gone, or another by now, has no view.
void add_views(const LintCommand& command, report::Report& report);

}  // namespace rad::cli
