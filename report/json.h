// radlint's report as JSON, of the shape that report.schema.json describes.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// The whole report. Always valid UTF-8; numbers round-trip; the same report gives the same bytes. `with_timings` adds
/// seconds, which differ from run to run.
std::string json(const Report& report, bool with_timings = false);

}  // namespace rad::report
