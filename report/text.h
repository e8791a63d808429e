// radlint's report as text for people.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "report/report.h"

namespace rad::report {

struct TextOptions {
  bool color = false;
  std::size_t width = 80;                   ///< columns
  std::optional<std::size_t> max_findings;  ///< listed for each rule; 0 lists all. Default: 10, for several files 3
};

/// The whole report. One file: header, findings by rule, a table of requirements, verdict, and the next command to
/// type. Several files: a block for each that fails and a line for each that passes, then the same for all of them.
std::string text(const Report& report, const TextOptions& options = {});

/// "radfix repairs it (grouper)": how findings of a rule are repaired; empty where there is nothing to repair.
std::string fix_text(const scene::Fix& fix);

/// "3 errors, 1 warning"; "no findings" for none.
std::string counts_text(const Counts& counts);

}  // namespace rad::report
