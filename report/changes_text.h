// What changed, as text for people. Only repair_text.cpp includes it.
#pragma once

#include <string>

#include "report/repair_report.h"
#include "report/text_layout.h"

namespace rad::report {

/// Findings by rule before and after, every operation, and the places of every sort of change.
void append_changes(std::string& out, const RepairReport& report, const Paint& paint, std::size_t width);

/// One line for each cell of Table 2 that was looked at.
void append_contracts(std::string& out, const std::vector<ContractCheck>& checks, const Paint& paint);

}  // namespace rad::report
