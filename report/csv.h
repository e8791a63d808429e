// A table for spreadsheets and data frames.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report {

/// RFC 4180 with a header, a row for each finding of each input on one line of its own. Text that a spreadsheet would
/// take for a formula gets an apostrophe in front. Lists are joined by "; ".
std::string csv(const Report& report);

}  // namespace rad::report
