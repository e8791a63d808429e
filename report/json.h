// radlint's report as JSON, of the shape that report.schema.json describes.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// The whole report. Always valid UTF-8; numbers round-trip; the same report gives the same bytes. `with_timings` adds
/// seconds, which differ from run to run.
std::string json(const Report& report, bool with_timings = false);

/// The same for each input alone, one to a line without indentation, each line a report of one input: lines of several
/// runs may be joined in any order.
std::string json_lines(const Report& report, bool with_timings = false);

}  // namespace rad::report
