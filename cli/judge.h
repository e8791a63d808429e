// Reading a model with what the user says about it, and judging it.
#pragma once

#include <span>
#include <string>

#include "cli/options.h"
#include "readers/reader.h"
#include "report/report.h"
#include "validate/lint.h"

namespace rad::cli {

struct Model {
  readers::ReadResult content;
  report::InputReport report;  ///< all but the verdict until judge() fills it
};

/// Reads `path`, or standard input (kStream). A unit or up axis from the command line replaces what the file declares.
Model read_model(const std::string& path, const ModelOptions& options);

/// The same of a text in memory; the path is that of standard input.
Model read_model_text(std::string_view text, const ModelOptions& options);

/// A model that is in memory, as if it had been read from `path`.
Model model_of(scene::Scene scene, const std::string& path);

/// Fills model.report.result. A file of which nothing could be read gets RL001 whatever rules are chosen.
void judge(Model& model, const validate::LintOptions& options);

/// The same, heeding what the model itself and the file beside it ask not to be told of. Adds that file to the
/// companions of the model, there or not.
void judge_with_waivers(Model& model, validate::LintOptions options);

/// A report in place of one that could not be made to the end: RL901 says why, and nothing else. `why` is a clause.
report::InputReport undecided(const std::string& path, const std::string& why, const validate::LintOptions& options);

/// "2 RL201 t-vertex, 1 RL210 implicit-intersection": findings of severity error, by rule.
std::string error_rules(std::span<const scene::Finding> findings);

}  // namespace rad::cli
