// Which reports a user asks for, in both programs.
#pragma once

#include <string>
#include <string_view>

#include "cli/options.h"

namespace rad::cli {

/// "json=R.json" taken apart; returns what is wrong with it, empty for nothing.
std::string read_file_report(const std::string& word, FileReport& into);
std::string read_file_report(const std::string& word, DiffFileReport& into);

/// A format by its name, as said after `option`; an empty word leaves what there is.
std::string read_format(std::string_view option, const std::string& word, const report::ReportFormat*& into);
std::string read_format(std::string_view option, const std::string& word, const report::DiffFormat*& into);

/// How a report is written where no terminal reads it: plain, 80 columns, paths relative to the repository that a build
/// runs in (GITHUB_WORKSPACE), else to the current folder.
report::WriteOptions file_write_options();

}  // namespace rad::cli
