// Findings as annotations of a GitHub Actions run.
#pragma once

#include <string>

#include "report/formats.h"

namespace rad::report {

/// Workflow commands (`::error file=…,line=…,title=…::…`) for the first ten findings of each severity, which is all
/// that GitHub shows of a step, and the text report after them.
std::string github(const Report& report, const WriteOptions& options);

}  // namespace rad::report
