// How radfix judges for its reports: as radlint is configured to. What repair decides and rolls back hangs on none of
// it.
#pragma once

#include <string>
#include <vector>

#include "cli/judge.h"
#include "cli/options.h"
#include "validate/lint.h"

namespace rad::cli {

struct FixJudging {
  validate::LintOptions options;  ///< of the input
  std::string configuration;      ///< path as reports name it; empty for none
};

/// What the configuration of the command's input says: of the model into command.model, of judging into the result.
/// Thin features (RL107) are looked for whatever it says. Throws config::ConfigFault where it is not understood.
FixJudging configure(FixCommand& command);

/// Judges the input as configured, heeding what it and the file beside it ask not to be told of. Returns what is found
/// when nothing is configured: all that is decided is decided by that.
validate::LintResult judge_input(Model& model, const FixJudging& judging);

/// For a model that was made of `input`: what is asked for the whole file, or by name, holds for it too. Other wishes
/// name places that it may not have, and none of them is said to be unused.
FixJudging judging_of_result(const Model& input, FixJudging judging);

/// Judges what was written.
void judge_result(Model& model, const FixJudging& judging);

}  // namespace rad::cli
