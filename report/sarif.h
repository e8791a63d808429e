// Findings as SARIF 2.1.0, the format of code scanning services.
#pragma once

#include <string>

#include "report/formats.h"

namespace rad::report {

/// Results that a run holds at most: what GitHub keeps of one.
inline constexpr std::size_t kSarifResults = 5'000;

/// One run with the table of all rules. Text formats have the line of the face as region; binary ones the first
/// character, and the JSON pointer and objects as logical locations. Fingerprints are those of the findings. Of more
/// than `limit` findings the worst of each rule are kept; one result for each rule that was cut says how many are
/// missing, and so does a notification.
std::string sarif(const Report& report, const WriteOptions& options);
std::string sarif(const Report& report, const WriteOptions& options, std::size_t limit);

}  // namespace rad::report
