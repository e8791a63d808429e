// The paper's Table 2 held against a run, filter by filter.
#pragma once

#include <string>
#include <vector>

#include "cli/fix_stages.h"
#include "report/changes.h"

namespace rad::cli {

/// Runs the filters of the command up to each of them and judges what lies between. One check for every cell of Table 2
/// that a rule tests.
std::vector<report::ContractCheck> check_contracts(const Model& model, const FixCommand& command, LiveLine& line,
                                                   const InterruptWatch& watch);

/// "isect does not generate 2b (no implicit intersections): 3 places are left"; empty where all hold.
std::string broken_contracts(const std::vector<report::ContractCheck>& checks);

}  // namespace rad::cli
