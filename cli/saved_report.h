// A report of an earlier run, read from its file.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::cli {

struct SavedReport {
  report::Report report;
  std::string problem;  ///< why there is none, with the path; empty for nothing
};

/// Whether a name is that of a report (.json, .jsonl) rather than of a model.
bool names_report(const std::string& path);

/// Reads what --report json= or jsonl= wrote; lines of one file become one report.
SavedReport read_saved_report(const std::string& path);

}  // namespace rad::cli
