// Judging many files: side by side, within limits, from the cache where nothing has changed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/file_plan.h"
#include "report/report.h"

namespace rad::cli {

struct JudgedFiles {
  std::vector<report::InputReport> inputs;  ///< in the order of the plan
  bool stopped = false;                     ///< before the end; then there are no inputs
};

/// Judges the files of a plan. `ended` is called with the number of files that are judged and the path of the last;
/// `stopped` is asked often. One file without limits is judged in this process with all threads, several in worker
/// processes where the plan allows them. A file that reaches a limit or whose process dies gets RL901.
JudgedFiles judge_files(const RunPlan& plan, const std::function<void(std::size_t, const std::string&)>& ended,
                        const std::function<bool()>& stopped);

}  // namespace rad::cli
