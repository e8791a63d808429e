// What a run of radfix did, gathered for its report.
#pragma once

#include <optional>

#include "cli/fix_stages.h"
#include "repair/face_history.h"
#include "report/repair_report.h"

namespace rad::cli {

/// What became of every face; nothing where nothing was done to any.
std::optional<repair::History> history_of(const Model& before, const Product& product);

/// Changes with their places; `history` is that of the product.
report::Changes changes_of(const Model& before, const repair::History& history);

/// Where every face of the product came from; nothing for a stage file, which says so itself.
std::optional<report::Provenance> provenance_of(const Model& before, const Product& product);

/// All but the verdict on what was written.
report::RepairReport report_of(const Model& before, const Product& product, const FixCommand& command);

/// `report` in the format of a file: as JSON or text all that was done; in every other format the verdict on the model
/// that was written or, where none was, on the input.
std::string written_report(const report::RepairReport& report, const FileReport& file, const FixCommand& command);

}  // namespace rad::cli
