// What a run of radfix did, as JSON.
#pragma once

#include <optional>
#include <string>

#include "report/report.h"

namespace rad::report {

struct RepairReport {
  Report before;                ///< the input as it was read; exactly one input
  std::optional<Report> after;  ///< the written file as it was read back; nothing where nothing was written
};

/// Before and after summaries, tolerance of the written coordinates, and the ledger of operations: empty, since this
/// version repairs nothing.
std::string json(const RepairReport& report);

}  // namespace rad::report
