// Findings as results of tests, for build servers.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// JUnit XML: a suite for each input and in it a case for each rule, so that rules which are kept show as passed. A
/// rule fails where a finding reaches fail_on; weaker findings stand in its output. Rules that did not run are skipped;
/// RL001 of a file that could not be read is an error, and so is a file that was judged in part. `with_timings` adds
/// seconds, which differ from run to run.
std::string junit(const Report& report, bool with_timings = false);

}  // namespace rad::report
