// A report for a comment on a pull request or the summary page of a build.
#pragma once

#include <string>

#include "report/markdown_text.h"
#include "report/report.h"

namespace rad::report {

/// First a hidden line by which a bot finds its comment again, then the verdict, a table of rules, one of files where
/// there are several, and the findings of each file. Kept below `limit` bytes: tables of findings go first, then rows
/// of files, each with a word that says so; the verdict and the rules stay.
std::string markdown(const Report& report, std::size_t limit = kMarkdownLimit);

}  // namespace rad::report
