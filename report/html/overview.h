// The upper part of the page: verdict, requirements, files.
#pragma once

#include <string>

#include "report/report.h"

namespace rad::report::html {

std::string verdict(const Report& report);

/// Tables 1 and 2 of the paper as this run answered them.
std::string requirement_table(const Report& report);

/// A row for each input, where there are several; else empty.
std::string file_table(const Report& report);

}  // namespace rad::report::html
