// The formats that a report is written in: one table for both programs.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "report/detail.h"
#include "report/report.h"
#include "report/text.h"

namespace rad::report {

struct WriteOptions {
  TextOptions text;
  bool timings = false;  ///< seconds, which differ from run to run, where the format has a place for them
  std::string root;      ///< absolute folder that paths are made relative to for code hosts; empty leaves them
};

struct ReportFormat {
  std::string_view name;  ///< as after --format and before the = of --report
  std::string_view what;  ///< a few words for the help
  Detail shows = Detail::Faces;
  bool is_limited = false;  ///< lists at most Report::max_issues findings of a rule
  std::string (*write)(const Report& report, const WriteOptions& options);
};

/// In the order in which the help names them; the first is that of standard output.
std::span<const ReportFormat> report_formats();

/// Null where there is none of that name.
const ReportFormat* find_report_format(std::string_view name);

/// "text, json, …", for messages.
std::string report_format_names();

}  // namespace rad::report
