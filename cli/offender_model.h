// `radlint --annotate`: the model with the faces that findings name in colour.
#pragma once

#include <string>

#include "cli/judge.h"
#include "cli/run_settings.h"

namespace rad::cli {

/// Writes a GLB or glTF file with a node and a material for each rule that has findings, named after it and holding all
/// faces that take part, and a grey one for the rest. A face that several rules name is in each of their nodes. The
/// legend in the extras says what the rules find. `model` was judged. Returns what went wrong, empty for nothing.
/// Faces without an inside to draw, such as degenerate ones, are left out.
std::string write_offenders(const std::string& path, const Model& model,
                            const std::optional<geom::ToleranceRequest>& tolerance);

/// The same for the run of a command, of whose `report` the findings are shown: one model, read again.
std::string annotate(const LintCommand& command, RunSettings& settings, const report::Report& report);

}  // namespace rad::cli
