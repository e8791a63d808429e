// Reports of radlint read back from JSON.
#pragma once

#include <string>
#include <string_view>

#include "report/report.h"

namespace rad::report {

struct ReadBack {
  Report report;
  std::string problem;  ///< why it cannot be read, as a clause; then the report says nothing
};

/// Reads what json() or json_lines() wrote. Written again with max_issues 0, a report gives the bytes it was read from.
ReadBack read_report(std::string_view text);

}  // namespace rad::report
