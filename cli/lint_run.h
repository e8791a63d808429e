// All files that a command names, judged.
#pragma once

#include <ostream>
#include <string>

#include "cli/options.h"
#include "cli/run_settings.h"

namespace rad::cli {

struct LintRun {
  report::Report report;
  std::string problem;  ///< why there is no report; empty for nothing
  int exit_code = 0;    ///< where there is none
};

/// Finds the files of the command, judges them and shows how far it is on `err`. `settings` are those of the command,
/// `detail` is what is wanted of findings, at least.
/// Throws config::ConfigFault where a file of configuration is not understood.
LintRun judge_paths(const LintCommand& command, RunSettings& settings, report::Detail detail, std::ostream& err,
                    const Terminal& terminal);

}  // namespace rad::cli
