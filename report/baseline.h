// Findings that are known and accepted: a run is judged by the others only.
#pragma once

#include <string>
#include <vector>

#include "report/report.h"

namespace rad::report {

/// What a baseline knows of one input that was judged.
struct BaselineUse {
  std::size_t input = 0;  ///< in the report that the baseline was applied to
  std::size_t entry = 0;  ///< input of the baseline
  /// Findings of the baseline that do not occur any more, by index.
  std::vector<std::size_t> stale;
};

/// Moves every finding that the baseline knows from `findings` to `known`, and marks the others: New, or Grown where a
/// known one has more violations or a higher severity than before. Faults are recognised by their places, as
/// match_findings() does it. Inputs that one side does not have stay as they are.
std::vector<BaselineUse> apply_baseline(const Report& baseline, Report& report);

/// `baseline` without what its uses found to be stale.
Report pruned(Report baseline, const std::vector<BaselineUse>& uses);

/// A baseline of all findings of a report: a JSON report with a line for each finding, in an order that the numbers of
/// faces do not decide. Paths are made relative to `folder`.
std::string baseline_json(const Report& report, const std::string& folder);

}  // namespace rad::report
