// The parts of the report of radfix that say what changed. Only repair_report.cpp includes it.
#pragma once

#include "report/changes.h"
#include "report/json_parts.h"

namespace rad::report {

Json changes_json(const Changes& changes);
Json merged_json(const std::vector<MergedRegion>& regions);
Json provenance_json(const Provenance& provenance);
Json contracts_json(const std::vector<ContractCheck>& checks);

}  // namespace rad::report
