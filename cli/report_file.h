// Writing a report to a place that the user named.
#pragma once

#include <string>
#include <string_view>

namespace rad::cli {

/// Writes `text` to `path`: a file appears in full or not at all, a device or pipe is written to as it is. Returns what
/// went wrong, empty for nothing.
std::string write_report_file(const std::string& path, std::string_view text);

}  // namespace rad::cli
